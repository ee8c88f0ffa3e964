#include "host/wide/wide_engine.hpp"

#include <omp.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <exception>

#include "host/render/gather.hpp"
#include "host/render/native_node.hpp"
#include "host/wide/tile_search.hpp"
#include "pxm/frame_buffer.hpp"

namespace pxm::host::wide {

namespace {

using Node = NativeNode<double>;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One thread's tools.
class TileRenderer {
  public:
    TileRenderer(const CompiledScene& scene, const WideScene& wide,
                 const std::vector<std::uint32_t>& block, Frame& frame)
        : scene_(scene),
          wide_(wide),
          block_(block),
          frame_(frame),
          node_(block, scene.texture_words, scene.heap, sizeof(kernels::Cell<double>)),
          heap_(node_),
          constants_(kernels::read_frame_constants(node_)) {
        int widest = table_step;
        for (const WideSet& set : wide.sets) widest = std::max(widest, set.stride);
        work_.scratch = hwy::AllocateAligned<double>(static_cast<std::size_t>(widest) * 32);
    }

    void render(long left, long top) {
        work_.tile = make_tile_view(scene_.camera, scene_.crop, left, top);
        search_tile(wide_, work_);
        for (std::uint64_t left_over = work_.tile.inside; left_over != 0;
             left_over &= left_over - 1) {
            finish(left, top, std::countr_zero(left_over));
        }
    }
    RayStatistics rays;

  private:
    /// Shades what a ray found, or lets the clear kernels find it.
    void finish(long left, long top, int ray) {
        const auto x = static_cast<std::uint32_t>(left + ray % tile_side);
        const auto y = static_cast<std::uint32_t>(top + ray / tile_side);
        const Found& found = work_.found[static_cast<std::size_t>(ray)];
        if (!found.given_up && store(found, ray, frame_.at(x, y))) return;
        kernels::render_pixel<kernels::plain_features>(node_, constants_, heap_, x, y, result_);
        result_.counts.volumes_tested += found.tested;
        gather_pixel(scene_, block_, result_, frame_.at(x, y), rays);
        frame_.at(x, y).node = static_cast<std::uint32_t>(ray);
    }
    /// Stores a miss, or a hit that can be confirmed in float.
    bool store(const Found& found, int ray, PixelRecord& pixel) {
        const auto tested = static_cast<std::uint32_t>(scene_.objects.size()) + found.tested;
        if (found.start < 0) {
            std::ranges::copy(wide_.background, pixel.color);
        } else {
            Shaded shaded;
            if (!shade_hit(wide_, work_, ray, shaded)) return false;
            std::ranges::copy(shaded.color, pixel.color);
            std::ranges::copy(shaded.normal, pixel.normal);
            pixel.alpha = 1;
            pixel.z = static_cast<float>(static_cast<double>(shaded.t) * wide_.unit);
            const CompiledObject& object = scene_.objects[static_cast<std::size_t>(shaded.object)];
            pixel.object = object.origin;
            pixel.level = static_cast<std::int32_t>(object.prefix.size()) + shaded.level;
            pixel.word = shaded.word;
            ++rays.hits;
        }
        pixel.volumes = tested;
        pixel.node = static_cast<std::uint32_t>(ray);
        ++rays.pixels;
        ++rays.eye_rays;
        rays.volumes_tested += tested;
        return true;
    }
    const CompiledScene& scene_;
    const WideScene& wide_;
    const std::vector<std::uint32_t>& block_;
    Frame& frame_;
    Node node_;
    kernels::Heap<Node> heap_;
    kernels::FrameConstants<double> constants_;
    kernels::PixelResult<double> result_;
    Workspace work_;
};

}  // namespace

EngineResult run_wide(const CompiledScene& scene, const EngineChoice& choice,
                      const RunControl& control) {
    const auto start = std::chrono::steady_clock::now();
    EngineResult result;
    const std::vector<std::uint32_t> block = make_scene_block<double>(scene);
    const WideScene wide = make_wide_scene(scene);
    result.frame = Frame(scene.size, scene.crop);
    result.scene_block_words = block.size();
    result.scene_block_hash = block_hash(block);
    result.load_seconds = seconds_since(start);

    const auto render_start = std::chrono::steady_clock::now();
    const long first_column = scene.crop.x0 / tile_side;
    const long first_row = scene.crop.y0 / tile_side;
    const long across = (scene.crop.x1 + tile_side - 1) / tile_side - first_column;
    const long tiles = across * ((scene.crop.y1 + tile_side - 1) / tile_side - first_row);
    std::atomic<long> done = 0;
    std::atomic<bool> stopped = false;
    std::exception_ptr failure;
#pragma omp parallel num_threads(choice.threads)
    {
        try {
            TileRenderer renderer(scene, wide, block, result.frame);
#pragma omp for schedule(dynamic, 4) nowait
            for (long tile = 0; tile < tiles; ++tile) {
                if (control.stop && *control.stop) stopped = true;
                if (stopped.load(std::memory_order_relaxed)) continue;
                renderer.render((first_column + tile % across) * tile_side,
                                (first_row + tile / across) * tile_side);
                const long finished = ++done;
                if (control.progress && omp_get_thread_num() == 0) {
                    control.progress(static_cast<double>(finished) / static_cast<double>(tiles));
                }
            }
#pragma omp critical(pxm_wide_sum)
            { result.rays.add(renderer.rays); }
        } catch (...) {
#pragma omp critical(pxm_wide_failure)
            failure = std::current_exception();
            stopped = true;
        }
    }
    if (failure) std::rethrow_exception(failure);
    result.stopped = stopped;
    result.render_seconds = seconds_since(render_start);
    return result;
}

}  // namespace pxm::host::wide
