// Laws of the node program in DSP32 code: its pictures are those of the counted kernels, bit for
// bit; what it does not know is refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "host/engine/assembled_node.hpp"
#include "host/engine/engine.hpp"
#include "host/node_program/assembled_program.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "pxm/frame_buffer.hpp"
#include "pxm/machine.hpp"
#include "tests/host/engine/assembled.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

using test::tetra_text;

TEST(AssembledMachine, tetra_menger_and_elm_are_those_of_the_counted_kernels) {
    for (const char* name : {"tetra", "menger", "elm"})
        expect_same(name, assembled("964dX", 24, 18));
}

TEST(AssembledMachine, so_are_other_systems_of_maps) {
    for (const char* name : {"octo", "icos", "dodec", "twindragon", "fir"})
        expect_same(name, assembled("964dX", 16, 12));
}

TEST(AssembledMachine, an_eye_within_the_attractor_sees_what_the_kernels_see) {
    RenderRequest request = assembled("964dX", 16, 12);
    request.overrides.zoom = 40;
    expect_same("tetra", request);
    request.overrides.zoom = 3;
    expect_same("menger", request);
}

TEST(AssembledMachine, a_window_of_the_picture_is_that_part_of_it) {
    RenderRequest request = assembled("940", 64, 48);
    const Frame whole = render_scene("tetra", request).frame;
    request.overrides.crop = CropWindow{13, 7, 50, 41};
    const Frame part = render_scene("tetra", request).frame;
    for (long y = 7; y < 41; ++y)
        for (long x = 13; x < 50; ++x) {
            ASSERT_EQ(part.at(x, y).color[0], whole.at(x, y).color[0]) << x << "," << y;
            ASSERT_EQ(part.at(x, y).word, whole.at(x, y).word) << x << "," << y;
        }
}

TEST(AssembledMachine, cycles_are_those_of_the_pixels_whatever_the_threads) {
    RenderRequest request = assembled("964dX", 24, 18);
    const RenderResult two = render_scene("tetra", request);
    request.threads = 1;
    const RenderResult one = render_scene("tetra", request);
    std::vector<std::uint64_t> of_pixels(64);
    for (const PixelRecord& pixel : one.frame.pixels) of_pixels[pixel.node] += pixel.cycles;
    for (std::size_t node = 0; node < 64; ++node) {
        EXPECT_EQ(one.statistics.machine->nodes[node].cycles, of_pixels[node]);
        EXPECT_EQ(two.statistics.machine->nodes[node].cycles, of_pixels[node]);
    }
}

/// What the front buffer should hold: 8 bits each of red, green, blue and alpha, rounded to
/// nearest.
std::uint32_t display_word(const PixelRecord& pixel) {
    std::uint32_t word = 0;
    for (const float value : {pixel.color[0], pixel.color[1], pixel.color[2], pixel.alpha}) {
        const double size = std::clamp(static_cast<double>(value), 0.0, 1.0);
        word = word << 8U | static_cast<std::uint32_t>(std::floor(size * 255 + 0.5));
    }
    return word;
}

TEST(AssembledMachine, pixels_are_in_the_front_buffer_and_nothing_is_read_too_early) {
    // One node with more pixels than a window on its front buffer shows.
    const Model model{"one", 1, 1, Certainty::assumed, 40, 30, Certainty::assumed};
    RenderRequest request;
    request.scene_path = scene_file("tetra").string();
    request.overrides.size = PixelSize{40, 30};
    const CompiledScene scene = compiled_scene_of(request);
    Machine<dsp32::Float> machine(model);
    ASSERT_FALSE(machine.open_frame(40, 30));
    ASSERT_FALSE(machine.broadcast(make_scene_block<dsp32::Float>(scene)));
    Node<dsp32::Float>& node = machine.nodes()[0];
    const UnitPixels unit{1, 2, 40, 30};
    AssembledNode program(node, scene, model, unit);
    std::vector<PixelRecord> records;
    RayStatistics counts;
    NodeEvent event = NodeEvent::working;
    while (event == NodeEvent::working || event == NodeEvent::pixel) {
        event = program.go_on();
        if (event == NodeEvent::pixel) program.take(records.emplace_back(), counts);
    }
    EXPECT_EQ(event, NodeEvent::done);
    EXPECT_EQ(program.stale_reads().count, 0U) << program.stale_reads().first_address;
    ASSERT_EQ(records.size(), unit.count());
    std::size_t i = 0;
    for (int y = 2; y < 30; ++y)
        for (int x = 1; x < 40; ++x)
            ASSERT_EQ(node.front_buffer().words()[pixel_in_node(model, 40, x, y)],
                      display_word(records[i++]))
                << x << "," << y;
}

/// The end of the message for what the program does not know, or nothing.
std::string refused(const std::string& text, const RenderRequest& request) {
    const std::string error = test::error_of([&] { (void)test::render_text(text, request); });
    const std::string start = "3: --program asm: the scene has ";
    if (!error.starts_with(start)) return error;
    return error.substr(start.size(), error.find(';') - start.size());
}

TEST(AssembledMachine, what_the_program_does_not_know_is_refused) {
    const std::string tetra = tetra_text;
    const RenderRequest plain = assembled("964dX", 16, 12);
    const auto with = [&](auto change) {
        RenderRequest request = plain;
        change(request.overrides);
        return refused(tetra, request);
    };
    EXPECT_EQ(refused(tetra, plain), "");
    EXPECT_EQ(with([](auto& o) { o.volume = VolumeKind::hull; }),
              "a bounding volume that is no ball and no box in axes (--volume sphere, or box)");
    EXPECT_EQ(with([](auto& o) { o.lipschitz = LipschitzMethod::polar; }),
              "Lipschitz constants by polar decomposition (--lipschitz product, or determinant)");
    EXPECT_EQ(with([](auto& o) { o.numeric = Numeric::double_; }),
              "numbers that are not a DSP32's (--numeric dsp32)");
    EXPECT_EQ(with([](auto& o) { o.shading = Shading::facet; }),
              "weights of the normals (--shading constant)");
    EXPECT_EQ(with([](auto& o) { o.intersect = IntersectMethod::fast; }),
              "the method of Chapter 13 (--intersect heap)");
    EXPECT_EQ(with([](auto& o) { o.heap = 255; }), "a heap that has not 256 entries (--heap 256)");
    EXPECT_EQ(refused(tetra + "light lamp { position: 2,3,-4 }", plain), "a point light");
    EXPECT_EQ(refused(tetra + "light sun { direction: 1,1,1 shadow: on }", plain),
              "a light that casts shadows");
    EXPECT_EQ(
        refused(tetra + "object a { ifs: tetra } object b { ifs: tetra translate: 2,0,0 }", plain),
        "2 objects (it knows one)");
    EXPECT_EQ(refused(tetra + "object a { ifs: tetra reflect: 0.5 }", plain),
              "a surface that reflects");
    EXPECT_EQ(refused(tetra + "render { covers: on }", plain),
              "local covers, or a translucent object (--covers off)");
    RenderRequest patient = plain;
    patient.cell_cap = 0x8000'0000;
    EXPECT_EQ(refused(tetra, patient), "a cap of more than 2147483647 cells");
    std::string many = "ifs many {\n";
    for (int i = 0; i < 30; ++i)
        many += fmt::format("newmap scale: 0.1 translate: {},{},0\n", 0.1 * i, 0.01 * i * i);
    EXPECT_EQ(refused(many + "}\n", plain), "a scene block of 1213 words (its window shows 1024)");
}

TEST(AssembledMachine, more_cells_than_the_heap_holds_stop_the_node) {
    std::string text = "ifs crowd {\n";
    for (int i = 0; i < 20; ++i)
        text += fmt::format("newmap scale: 0.9 translate: {},{},{}\n", 0.01 * i, 0.003 * i, 0.002);
    const std::string error = refused(text + "}\n", assembled("964dX", 32, 24));
    EXPECT_TRUE(error.starts_with("5: node ")) << error;
    EXPECT_TRUE(error.find("needs more than the 256 cells of the heap") != std::string::npos)
        << error;
}

TEST(AssembledMachine, what_it_has_when_it_is_stopped_is_a_part_of_the_picture) {
    RenderRequest request;
    request.scene_path = scene_file("tetra").string();
    request.overrides.size = PixelSize{40, 30};
    const CompiledScene scene = compiled_scene_of(request);
    EngineChoice choice;
    choice.machine = find_model("964dX");
    choice.numeric = Numeric::dsp32;
    choice.code = NodeCode::assembled;
    std::atomic<bool> stop = false;
    const RunControl control{&stop, [&](double) { stop = true; }};
    const auto done = [](const Frame& frame) {
        return std::ranges::count_if(frame.pixels, [](auto& pixel) { return pixel.cycles > 0; });
    };
    std::ptrdiff_t taken = 0;
    const BlockTaker taker{[&](Frame& frame) { taken = done(frame); }};
    const auto loaded = load_assembled_machine(scene, choice);
    const EngineResult result = loaded->run(scene.crop, control, &taker);
    EXPECT_TRUE(result.stopped);
    EXPECT_GE(taken, 256);
    EXPECT_LT(taken, 40 * 30);
    EXPECT_GT(result.machine->nodes[0].cycles, 0U);
}

TEST(AssembledMachine, its_program_fits_the_fast_memory_and_says_of_what_it_is_made) {
    const RenderResult result = render_scene("tetra", assembled("964dX", 8, 8));
    const NodeProgram& program = result.statistics.program;
    EXPECT_EQ(
        program.used_bytes(),
        static_cast<std::int64_t>(AssembledProgram(kernels::Volume::sphere).words().size() * 4));
    EXPECT_EQ(program.used_bytes(), result.statistics.machine->fast_memory.used_bytes);
    EXPECT_LT(program.used_bytes(), fast_memory_bytes);
    EXPECT_EQ(program.modules.front().name, "program");
    const std::string said = fmt::format("It takes {},{:03} of the 36,864 bytes of fast memory",
                                         program.used_bytes() / 1000, program.used_bytes() % 1000);
    const auto document = std::filesystem::path(test::source_dir) / "docs/machine.md";
    EXPECT_NE(test::text_of(document).find(said), std::string::npos) << said;
    const std::size_t with_boxes = AssembledProgram(kernels::Volume::box).words().size() * 4;
    const std::string also =
        fmt::format("With boxes it takes {},{:03}.", with_boxes / 1000, with_boxes % 1000);
    EXPECT_NE(test::text_of(document).find(also), std::string::npos) << also;
}

}  // namespace
}  // namespace pxm::host
