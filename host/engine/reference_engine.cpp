// The reference engine: the node program itself on the cores at hand, tile by tile.
#include <algorithm>
#include <utility>

#include "host/engine/engine.hpp"
#include "host/engine/gather.hpp"
#include "host/engine/neighbour_walk.hpp"
#include "host/engine/tiles.hpp"
#include "host/node_program/crowded.hpp"
#include "host/node_program/instances.hpp"
#include "pxm/frame_buffer.hpp"

namespace pxm::host {

namespace {

constexpr long part_side = 8 * tile_side;  // of what one thread renders at a stretch, at most

/// The part of a tile that lies in the window.
kernels::PixelShare tile_share(const CropWindow& window, long left, long top) {
    const auto pixel = [](long v) { return static_cast<std::uint32_t>(v); };
    return {pixel(std::max(left, window.x0)),
            pixel(std::max(top, window.y0)),
            pixel(std::min(left + tile_side, window.x1)),
            pixel(std::min(top + tile_side, window.y1)),
            1,
            1};
}

/// The number of the neighbourhood of the cell that a pixel shows; 0 where it shows none, or nobody
/// asked.
template <class Real>
std::uint64_t neighbourhood(const CompiledScene& scene, const std::vector<std::uint32_t>& block,
                            const NeighbourWalks& walks, const kernels::PixelResult<Real>& result) {
    if (result.floor.plane != 0 || result.found.outcome == kernels::Outcome::miss) return 0;
    const kernels::Cell<Real>& cell = result.found.cell;
    const CompiledObject& object = scene.objects[object_index<Real>(block, cell.object)];
    const auto& walk = walks[static_cast<std::size_t>(object.shape)];
    if (!walk) return 0;
    std::int32_t state = 0;
    const auto step = [&](int map) {
        if (state >= 0)
            state = walk->next[static_cast<std::size_t>(state)][static_cast<std::size_t>(map)];
    };
    for (const int map : object.prefix) step(map);
    for (std::uint32_t i = 0; i < cell.level; ++i)
        step(static_cast<int>(cell.word.get(i, cell.bits)));
    return static_cast<std::uint64_t>(state + 1);
}

/// What one thread renders with.
template <class Real, kernels::Features features>
class ReferenceTracer {
  public:
    ReferenceTracer(const CompiledScene& scene, const std::vector<std::uint32_t>& block,
                    const NeighbourWalks& walks)
        : scene_(scene),
          block_(block),
          walks_(walks),
          node_(make_native_node<NativeNode<Real>>(scene, block)) {
        clear_overflow();  // a thread keeps the flags of what it computed before
    }

    void render(Frame& frame, long left, long top, const GoOn& go_on) {
        kernels::pixel_program<features>(
            node_, tile_share(frame.crop, left, top),
            [&](std::uint32_t x, std::uint32_t y, const kernels::PixelResult<Real>& pixel) {
                PixelRecord& record = frame.at(x, y);
                gather_pixel(scene_, block_, pixel, record, rays_);
                if (!walks_.empty()) record.cycles = neighbourhood(scene_, block_, walks_, pixel);
                const NodeId id = owner(model_, static_cast<int>(x), static_cast<int>(y));
                record.node = static_cast<std::uint16_t>(id.row * model_.columns + id.column);
                return go_on();
            });
    }

    [[nodiscard]] RayStatistics finish() { return std::exchange(rays_, {}); }

  private:
    const CompiledScene& scene_;
    const std::vector<std::uint32_t>& block_;
    const NeighbourWalks& walks_;
    const Model& model_ = *find_model("964");  // for the `node` channel
    NativeNode<Real> node_;
    RayStatistics rays_;
};

template <class Real, kernels::Features features>
class LoadedReferenceScene : public LoadedScene {
  public:
    LoadedReferenceScene(const CompiledScene& scene, int threads, NeighbourWalks walks)
        : scene_(scene), threads_(threads), walks_(std::move(walks)) {
        block_ = make_scene_block<Real>(scene);
    }

    using LoadedScene::run;
    EngineResult run(const CropWindow& window, const RunControl& control,
                     const BlockTaker* taker) override {
        return run_tiles({scene_.size, window, part_side, threads_}, control, taker, [&] {
            return std::make_unique<ReferenceTracer<Real, features>>(scene_, block_, walks_);
        });
    }

    [[nodiscard]] UnitGrid grid(const CropWindow& window) const override {
        return grid_of_tiles(window, part_side);
    }

    UnitsRun run_units(const UnitGrid&, const UnitWork& work, const RunControl& control) override {
        return run_tile_units(scene_.size, work, threads_, control, [&] {
            return std::make_unique<ReferenceTracer<Real, features>>(scene_, block_, walks_);
        });
    }

  private:
    const CompiledScene& scene_;
    int threads_;
    NeighbourWalks walks_;
};

}  // namespace

std::unique_ptr<LoadedScene> load_reference(const CompiledScene& scene,
                                            const EngineChoice& choice) {
    return load_reference_with(scene, choice, {});
}

std::unique_ptr<LoadedScene> load_reference_with(const CompiledScene& scene,
                                                 const EngineChoice& choice, NeighbourWalks walks) {
    return with_instance(scene, choice.numeric, [&]<class Real, kernels::Features features>() {
        return std::unique_ptr<LoadedScene>(
            new LoadedReferenceScene<Real, features>(scene, choice.threads, std::move(walks)));
    });
}

EngineResult run_reference(const CompiledScene& scene, const EngineChoice& choice,
                           const RunControl& control) {
    return load_reference(scene, choice)->run(scene.crop, control);
}

}  // namespace pxm::host
