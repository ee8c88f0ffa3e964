#include "host/wide/tile/wide_engine.hpp"

#include "host/engine/tiles.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "host/wide/tile/tile_tracer.hpp"

namespace pxm::host::wide {

namespace {

class LoadedWideScene : public LoadedScene {
  public:
    LoadedWideScene(const CompiledScene& scene, int threads)
        : scene_(scene), threads_(threads), wide_(make_wide_scene(scene)), rest_(scene, wide_) {
        block_ = make_scene_block<double>(scene);
    }

    using LoadedScene::run;
    EngineResult run(const CropWindow& window, const RunControl& control,
                     const BlockTaker* taker) override {
        return run_tiles(
            {scene_.size, window, wide_.candidate_view_side, threads_}, control, taker,
            [&] { return std::make_unique<TileTracer>(scene_, wide_, rest_, block_); });
    }

    [[nodiscard]] UnitGrid grid(const CropWindow& window) const override {
        return grid_of_tiles(window, wide_.candidate_view_side);
    }

    UnitsRun run_units(const UnitGrid&, const UnitWork& work, const RunControl& control) override {
        return run_tile_units(scene_.size, work, threads_, control, [&] {
            return std::make_unique<TileTracer>(scene_, wide_, rest_, block_);
        });
    }

  private:
    const CompiledScene& scene_;
    int threads_;
    WideScene wide_;
    ReferenceFallback rest_;
};

}  // namespace

std::unique_ptr<LoadedScene> load_wide(const CompiledScene& scene, const EngineChoice& choice) {
    return std::make_unique<LoadedWideScene>(scene, choice.threads);
}

EngineResult run_wide(const CompiledScene& scene, const EngineChoice& choice,
                      const RunControl& control) {
    return load_wide(scene, choice)->run(scene.crop, control);
}

}  // namespace pxm::host::wide
