// Same input, same pixels: on the machine and natively, for any number of threads, any heap, any
// window (docs/design.md, decisions 1, 6 and 9).
#include <gtest/gtest.h>

#include <bit>

#include "pxm/model.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr Numeric all_numbers[] = {Numeric::dsp32, Numeric::single, Numeric::double_};

/// What may differ between two frames.
struct Ignored {
    bool node = false;    // another model
    bool effort = false;  // another heap: volumes tested, heap peak
};

std::string difference(const Frame& a, const Frame& b, const Ignored& ignored = {}) {
    if (a.pixels.size() != b.pixels.size()) return "other sizes";
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const PixelRecord& p = a.pixels[i];
        const PixelRecord& q = b.pixels[i];
        bool same = bits(p.alpha) == bits(q.alpha) && bits(p.z) == bits(q.z) &&
                    p.object == q.object && p.level == q.level && p.word == q.word;
        for (int c = 0; c < 3; ++c) {
            same = same && bits(p.color[c]) == bits(q.color[c]) &&
                   bits(p.normal[c]) == bits(q.normal[c]);
        }
        same = same && (ignored.node || p.node == q.node);
        same = same && (ignored.effort || (p.volumes == q.volumes && p.heap == q.heap));
        if (!same) return "pixel " + std::to_string(i);
    }
    return "";
}

/// A few scenes that between them use every kernel.
std::vector<Example> mixed_scenes(const std::string& size) {
    std::vector<Example> chosen;
    for (const Example& example : example_scenes(size)) {
        for (const char* name : {"inside", "overlapping", "hierarchical", "orthographic", "elm",
                                 "squashed_polar_box", "mirrored_determinant_sphere", "primitives",
                                 "squashed_oriented", "tetra_hull", "declared_cone"}) {
            if (example.name == name) chosen.push_back(example);
        }
    }
    return chosen;
}

TEST(SamePicture, on_the_machine_and_natively) {
    for (const Example& example : mixed_scenes("21,13")) {
        const CompiledScene scene = compile_text(example.text);
        for (const Numeric numeric : all_numbers) {
            const Frame native = render_natively(scene, numeric).frame;
            EXPECT_EQ(difference(native, render_on("964", scene, numeric).frame), "")
                << example.name;
            EXPECT_EQ(difference(native, render_on("916", scene, numeric).frame, {.node = true}),
                      "")
                << example.name;
        }
    }
}

TEST(SamePicture, with_one_two_three_and_sixty_four_threads) {
    for (const Example& example : mixed_scenes("37,22")) {
        const CompiledScene scene = compile_text(example.text);
        const EngineResult native = render_natively(scene, Numeric::single, 1);
        const EngineResult machine = render_on("964", scene, Numeric::single, 1);
        for (const int threads : {2, 3, 64}) {
            const EngineResult n = render_natively(scene, Numeric::single, threads);
            EXPECT_EQ(difference(native.frame, n.frame), "") << example.name << threads;
            EXPECT_EQ(native.rays.volumes_tested, n.rays.volumes_tested);
            EXPECT_EQ(native.rays.heap_peak, n.rays.heap_peak);
            const EngineResult m = render_on("964", scene, Numeric::single, threads);
            EXPECT_EQ(difference(machine.frame, m.frame), "") << example.name << threads;
            for (std::size_t i = 0; i < machine.frame.pixels.size(); ++i) {
                EXPECT_EQ(machine.frame.pixels[i].cycles, m.frame.pixels[i].cycles);
            }
        }
    }
}

TEST(SamePicture, with_heaps_of_one_four_and_eight_cells) {
    std::uint64_t restarts = 0;
    for (const Example& example : mixed_scenes("20,15")) {
        CompiledScene scene = compile_text(example.text);
        for (const Numeric numeric : all_numbers) {
            scene.heap = 256;
            const EngineResult roomy = render_natively(scene, numeric);
            for (const long heap : {1L, 4L, 8L}) {
                scene.heap = heap;
                const EngineResult narrow = render_natively(scene, numeric);
                EXPECT_EQ(difference(roomy.frame, narrow.frame, {.effort = true}), "")
                    << example.name << " heap " << heap;
                restarts += narrow.rays.restarts;
            }
        }
    }
    EXPECT_GT(restarts, 0);
}

/// The eye inside of every cell down to the last level: all keys are 0.
TEST(SamePicture, with_any_heap_where_all_keys_are_equal) {
    CompiledScene scene = compile_text(
        ifs("octo") +
        "object a { ifs: octo sphere: (0,0,0) 40 levels: 3 }"
        "camera { eye: 0.01,0.02,0.03 look: 0,0,1 } image { size: 12,9 } render { heap: 256 }");
    for (CompiledSet& set : scene.shapes[0].sets) {
        ASSERT_GT(set.volume.radius, 30 / scene.unit);
    }
    const EngineResult roomy = render_natively(scene, Numeric::single);
    for (const PixelRecord& pixel : roomy.frame.pixels) {
        ASSERT_EQ(pixel.z, 0);
        ASSERT_EQ(pixel.level, 3);
    }
    for (const long heap : {1L, 2L, 4L, 8L}) {
        scene.heap = heap;
        const EngineResult narrow = render_natively(scene, Numeric::single);
        EXPECT_EQ(difference(roomy.frame, narrow.frame, {.effort = true}), "") << heap;
        EXPECT_EQ(narrow.rays.heap_overflows, narrow.rays.eye_rays) << heap;
    }
}

TEST(SamePicture, in_a_window_as_in_the_whole_image) {
    const std::string view = "camera { eye: 1,2,-4 look: 0,0,0 fov: 40 }";
    const CompiledScene whole = compile_text(scene_of("tetra", "", "size: 45,29") + view);
    const Frame full = render_natively(whole, Numeric::single).frame;
    for (const char* crop : {"0,0,1,1", "44,28,45,29", "7,9,30,17", "8,8,16,16", "3,0,4,29"}) {
        const CompiledScene part =
            compile_text(scene_of("tetra", "", std::string("size: 45,29 crop: ") + crop) + view);
        for (const Frame& frame : {render_natively(part, Numeric::single, 2).frame,
                                   render_on("964", part, Numeric::single).frame}) {
            Frame expected(full.size, part.crop);
            for (long y = part.crop.y0; y < part.crop.y1; ++y) {
                for (long x = part.crop.x0; x < part.crop.x1; ++x) {
                    expected.at(x, y) = full.at(x, y);
                }
            }
            EXPECT_EQ(difference(expected, frame), "") << crop;
        }
    }
}

TEST(SamePicture, of_any_size_has_every_pixel_once) {
    for (const char* size : {"1,1", "1,9", "7,1", "8,8", "9,17", "13,5"}) {
        const CompiledScene scene =
            compile_text(scene_of("octo", "", std::string("size: ") + size));
        const EngineResult native = render_natively(scene, Numeric::single, 3);
        const EngineResult machine = render_on("964", scene, Numeric::single);
        EXPECT_EQ(difference(native.frame, machine.frame), "") << size;
        EXPECT_EQ(native.rays.eye_rays, native.frame.pixels.size()) << size;
        EXPECT_EQ(machine.rays.eye_rays, machine.frame.pixels.size()) << size;
    }
}

/// Node (i, j) owns the pixels with x mod columns = i and y mod rows = j.
TEST(Ownership, every_pixel_says_the_one_node_that_owns_it) {
    for (const char* name : {"964", "916", "940"}) {
        const Model& model = *find_model(name);
        const CompiledScene scene =
            compile_text(scene_of("octo", "", "size: 43,31 crop: 2,1,41,30"));
        const EngineResult result = render_on(name, scene, Numeric::single);
        std::vector<std::uint64_t> owned(static_cast<std::size_t>(model.nodes()));
        for (long y = scene.crop.y0; y < scene.crop.y1; ++y) {
            for (long x = scene.crop.x0; x < scene.crop.x1; ++x) {
                const long node = y % model.rows * model.columns + x % model.columns;
                EXPECT_EQ(result.frame.at(x, y).node, node) << name << ' ' << x << ' ' << y;
                ++owned[static_cast<std::size_t>(node)];
            }
        }
        ASSERT_TRUE(result.machine.has_value());
        ASSERT_EQ(result.machine->nodes.size(), owned.size());
        for (const NodeStatistics& node : result.machine->nodes) {
            EXPECT_EQ(node.id, node.row * model.columns + node.column) << name;
            EXPECT_EQ(node.rays.eye_rays, owned[static_cast<std::size_t>(node.id)]) << name;
        }
    }
}

}  // namespace
}  // namespace pxm::test
