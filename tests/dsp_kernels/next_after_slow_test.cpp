// What rays cost whose heap is far smaller than their paths are long, or whose beam meets very many
// cells: counted on grass, whose blades take over a hundred levels.
#include <gtest/gtest.h>

#include <numeric>

#include "host/render/render.hpp"
#include "pxm/model.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

std::uint64_t cycles_of_grass(long heap) {
    RenderRequest request;
    request.scene_path = source_dir + "/scenes/grass.pxm";
    request.machine = find_model("964dX");
    request.overrides.numeric = Numeric::single;
    request.overrides.size = PixelSize{12, 9};
    request.overrides.heap = heap;
    const RenderResult result = render(request, {});
    std::uint64_t cycles = 0;
    for (const auto& node : result.statistics.machine->nodes) cycles += node.cycles;
    return cycles;
}

/// A path that is made again from its beginning at every step back cost 20 times as much.
TEST(NextAfter, grass_with_a_small_heap_costs_a_small_multiple) {
    EXPECT_LT(cycles_of_grass(8), 10 * cycles_of_grass(256));
}

TEST(NextAfter, grass_shows_the_same_picture_with_any_heap) {
    CompiledScene scene = compile_text(scene_of("grass", "", "size: 12,9"));
    const Frame roomy = render_on("964dX", scene, Numeric::single, 2).frame;
    for (const long heap : {3, 5, 8, 13}) {
        scene.heap = heap;
        const EngineResult narrow = render_on("964dX", scene, Numeric::single, 2);
        EXPECT_GT(narrow.rays.heap_overflows, 0U);
        Frame frame = narrow.frame;
        for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
            frame.pixels[i].volumes = roomy.pixels[i].volumes;
            frame.pixels[i].heap = roomy.pixels[i].heap;
            frame.pixels[i].cycles = roomy.pixels[i].cycles;
        }
        EXPECT_TRUE(same_picture(frame, roomy)) << heap;
    }
}

/// A beam stops at 1/128 of the cap on cells, and leaves its places to rays.
TEST(Beam, over_grass_meets_no_more_cells_than_it_may) {
    const CompiledScene scene = compile_text(scene_of("grass", "covers: area", "size: 12,9"));
    const EngineResult result = render_natively(scene, Numeric::single, 2);
    EXPECT_EQ(result.rays.capped_rays, 0U);
    EXPECT_LT(result.rays.volumes_tested, 12U * 9U * (7813U + 12U * 1000U));
    EXPECT_GT(result.rays.hits, 20U);
}

}  // namespace
}  // namespace pxm::test
