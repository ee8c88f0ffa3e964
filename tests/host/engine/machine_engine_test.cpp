// Laws of the machine engine: one picture on all models, counted time, the limits of the memories.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "host/node_program/write_scene_block.hpp"
#include "host/output/statistics_json.hpp"
#include "pxm/frame_buffer.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host {
namespace {

using test::on_machine;
using test::render_text;
using test::same_picture;
using test::tetra_text;

/// A point light, two weightings' worth of work: shading, lights and boxes besides the descent.
const std::string lit_text = std::string(tetra_text) + R"(
object tetra { ifs: tetra box: (-1,-1,-1)(1,1,1) }
light lamp { position: 2,3,-4 }
render { shading: high-pass }
)";

std::vector<std::uint64_t> node_cycles(const RenderResult& result) {
    std::vector<std::uint64_t> cycles;
    for (const NodeStatistics& node : result.statistics.machine->nodes) {
        cycles.push_back(node.cycles);
    }
    return cycles;
}

TEST(MachineEngine, all_models_make_the_same_picture) {
    const RenderResult first = render_text(lit_text, on_machine("916", 41, 23));
    EXPECT_GT(first.statistics.rays.hits, 50U);
    for (const Model& model : models()) {
        const RenderResult result =
            render_text(lit_text, on_machine(std::string(model.name).c_str(), 41, 23));
        EXPECT_TRUE(same_picture(result.frame, first.frame)) << model.name;
        ASSERT_EQ(result.statistics.machine->nodes.size(), static_cast<std::size_t>(model.nodes()));
        std::uint64_t pixels = 0;
        for (const NodeStatistics& node : result.statistics.machine->nodes) {
            EXPECT_EQ(node.rays.eye_rays, static_cast<std::uint64_t>(owned_pixels(
                                              model, {node.column, node.row}, 41, 23)));
            pixels += node.rays.eye_rays;
        }
        EXPECT_EQ(pixels, 41U * 23U);
    }
}

TEST(MachineEngine, a_pixel_is_made_by_the_node_that_owns_it) {
    const RenderResult result = render_text(tetra_text, on_machine("940", 23, 11));
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 23; ++x) {
            EXPECT_EQ(result.frame.at(x, y).node, static_cast<std::uint32_t>(y % 4 * 10 + x % 10));
        }
    }
}

TEST(MachineEngine, the_cycles_of_its_pixels_sum_to_a_node_s) {
    for (const char* crop : {"", "5,3,9,6"}) {
        RenderRequest request = on_machine("932", 29, 17);
        if (*crop) request.overrides.crop = CropWindow{5, 3, 9, 6};
        const RenderResult result = render_text(lit_text, request);
        std::vector<std::uint64_t> sums(32);
        for (const PixelRecord& pixel : result.frame.pixels) sums[pixel.node] += pixel.cycles;
        EXPECT_EQ(sums, node_cycles(result));
    }
}

TEST(MachineEngine, the_cycles_do_not_depend_on_run_or_threads) {
    RenderRequest request = on_machine("916", 24, 24);
    std::vector<std::uint64_t> first;
    for (const int threads : {1, 2, 7, 2}) {
        request.threads = threads;
        const auto cycles = node_cycles(render_text(lit_text, request));
        if (first.empty()) first = cycles;
        EXPECT_EQ(cycles, first) << threads << " threads";
    }
}

TEST(MachineEngine, operations_explain_instructions_and_cycles) {
    const RenderResult result = render_text(lit_text, on_machine("916", 16, 16));
    const CostTable& table = default_cost_table();
    for (const NodeStatistics& node : result.statistics.machine->nodes) {
        EXPECT_EQ(node.cycles, cycles(node.tally, table));
        EXPECT_EQ(node.instructions, instructions(node.tally, table));
        EXPECT_LT(node.instructions, node.cycles);
    }
    for (const Operation used :
         {Operation::transform_point, Operation::reciprocal, Operation::divide, Operation::call,
          Operation::shape_sequential, Operation::heap_scattered, Operation::heap_sift}) {
        EXPECT_GT(result.statistics.machine->tally.counts[static_cast<std::size_t>(used)], 0U);
    }
    const auto pixels = static_cast<std::size_t>(Operation::pixel_write);
    EXPECT_EQ(result.statistics.machine->tally.counts[pixels], 256U);
}

TEST(MachineEngine, a_cost_model_changes_the_cycles_and_not_the_picture) {
    RenderRequest request = on_machine("916", 16, 16);
    const RenderResult with_default = render_text(tetra_text, request);
    for (OperationCost& cost : request.costs.table.operations)
        cost = {2 * cost.tight, 2 * cost.plain};
    request.costs.name = "double.json";
    const RenderResult with_double = render_text(tetra_text, request);
    EXPECT_TRUE(same_picture(with_default.frame, with_double.frame));
    EXPECT_EQ(with_double.statistics.machine->costs.name, "double.json");
    for (std::size_t i = 0; i < 16; ++i) {
        const double once = static_cast<double>(node_cycles(with_default)[i]);
        EXPECT_NEAR(static_cast<double>(node_cycles(with_double)[i]), 2 * once, 1);
    }
}

// machine-facts, Sec. 5: five minutes a picture are some 73 000 instructions a pixel. A coarse band
// around that, not a validation.
TEST(MachineEngine, the_five_solids_lie_in_the_band_of_five_minutes) {
    RenderRequest request = on_machine("964dX", 640, 480);
    request.scene_path = test::source_dir + "/scenes/five_solids.pxm";
    request.overrides.crop = CropWindow{288, 200, 352, 232};
    const RenderResult result = render(request, {});
    const auto cycles = node_cycles(result);
    const double per_pixel =
        static_cast<double>(std::accumulate(cycles.begin(), cycles.end(), std::uint64_t{0})) /
        static_cast<double>(result.frame.pixels.size());
    EXPECT_GT(per_pixel, 1e3);
    EXPECT_LT(per_pixel, 1e7);
    RecordProperty("cycles_per_pixel", std::to_string(per_pixel));
}

TEST(MachineEngine, heaps_of_all_sizes_make_the_same_picture) {
    RenderRequest request = on_machine("916", 24, 24);
    const RenderResult full = render_text(lit_text, request);
    EXPECT_EQ(full.statistics.rays.heap_overflows, 0U);
    std::uint64_t overflows = ~std::uint64_t{0};
    for (const long heap : {1L, 2L, 4L, 16L}) {
        request.overrides.heap = heap;
        const RenderResult small = render_text(lit_text, request);
        EXPECT_TRUE(same_picture(small.frame, full.frame)) << heap;
        EXPECT_LE(small.statistics.rays.heap_overflows, overflows);
        overflows = small.statistics.rays.heap_overflows;
        if (heap == 1) {
            EXPECT_GT(overflows, 0U);
            EXPECT_GT(node_cycles(small)[5], node_cycles(full)[5]);
        }
    }
}

std::string fault_of(const std::string& text, const RenderRequest& request) {
    return test::error_of([&] { (void)render_text(text, request); });
}

TEST(MachineEngine, a_frame_too_large_for_the_front_buffer_is_a_fault) {
    EXPECT_EQ(fault_of(tetra_text, on_machine("916", 4096, 4096)),
              "5: the front buffer of node 0 of the 916 is too small: 4194304 bytes wanted, "
              "262144 there");
    EXPECT_EQ(fault_of(tetra_text, on_machine("964dX", 65536, 65536)),
              "5: the front buffer of node 0 of the 964dX is too small: 268435456 bytes wanted, "
              "262144 there");
}

TEST(MachineEngine, a_frame_that_just_fits_is_none) {
    RenderRequest request = on_machine("916", 1024, 1024);
    request.overrides.crop = CropWindow{512, 512, 514, 514};
    const RenderResult result = render_text(tetra_text, request);
    EXPECT_EQ(result.statistics.machine->front_buffer.used_bytes, bank_bytes);
    EXPECT_EQ(result.statistics.machine->front_buffer.limit_bytes, bank_bytes);
    request = on_machine("916", 1025, 1024);
    EXPECT_EQ(fault_of(tetra_text, request),
              "5: the front buffer of node 0 of the 916 is too small: 263168 bytes wanted, "
              "262144 there");
}

TEST(MachineEngine, a_scene_too_large_for_the_back_buffer_is_a_fault) {
    std::string many = tetra_text;
    for (int i = 0; i < 2000; ++i) {
        many += "object o" + std::to_string(i) + " { ifs: tetra }\n";
    }
    const std::size_t words = make_scene_block<dsp32::Float>(test::compile_text(many)).size();
    EXPECT_EQ(
        fault_of(many, on_machine("964dX", 16, 16)),
        fmt::format("5: the back buffer of node 0 of the 964dX is too small: {} bytes wanted, "
                    "262144 there",
                    4 * words));
}

TEST(MachineEngine, a_heap_too_large_for_the_z_buffer_is_a_fault) {
    RenderRequest request = on_machine("964dX", 16, 16);
    request.overrides.heap = 415;  // 316 bytes each
    EXPECT_EQ(fault_of(tetra_text, request),
              "5: the z-buffer of node 0 of the 964dX is too small: 131140 bytes wanted, "
              "131072 there");
    request.overrides.heap = 414;
    EXPECT_EQ(fault_of(tetra_text, request), "");
}

TEST(MachineEngine, memories_in_use_are_told) {
    const RenderResult result = render_text(tetra_text, on_machine("964dX", 64, 48));
    const MachineStatistics& machine = *result.statistics.machine;
    EXPECT_EQ(machine.front_buffer.used_bytes, 8 * 6 * 4);
    EXPECT_EQ(machine.back_buffer.used_bytes,
              static_cast<std::int64_t>(result.statistics.scene_block_words) * 4);
    EXPECT_EQ(machine.zbuffer.used_bytes, 256 * 316);
    EXPECT_EQ(machine.zbuffer.limit_bytes, zbuffer_part_bytes);
    EXPECT_EQ(machine.texture.used_bytes, 0);
    EXPECT_EQ(machine.texture.limit_bytes, texture_part_bytes);
}

}  // namespace
}  // namespace pxm::host
