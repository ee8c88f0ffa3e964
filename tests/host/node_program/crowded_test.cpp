// Laws of cells that overlap (host/node_program/crowded, host/node_program/known_cells).
#include "host/node_program/crowded.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "host/compile/shape.hpp"
#include "host/compiled/bounding_volume.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "host/render/alarms.hpp"
#include "tests/host/fractal/systems.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/crowds.hpp"
#include "tests/support/example_scenes.hpp"

namespace pxm::test {
namespace {

using namespace host;

TEST(Crowded, are_systems_whose_words_lead_to_the_same_cells) {
    EXPECT_TRUE(has_crowded_objects(compile_text(fat_square(4))));
    EXPECT_TRUE(has_crowded_objects(compile_text(square_of_coinciding_cells(4))));
    for (const auto& [name, rifs] : systems::thesis_systems()) {
        const Bounds whole = bound(rifs, prove_contraction(rifs))[0];
        const std::vector<CompiledVolume> balls(
            rifs.follow_sets.size(), sphere_volume(whole.ball.center, whole.ball.radius));
        EXPECT_FALSE(is_crowded(
            make_shape(rifs, balls, frame_around(whole.ball), kernels::Lipschitz::product)))
            << name;
    }
}

/// Loose volumes overlap, however far apart the cells' attractors are.
TEST(Crowded, are_not_systems_with_loose_volumes) {
    EXPECT_FALSE(has_crowded_objects(
        compile_text(ifs("octo") + "object a { ifs: octo sphere: (0,0,0) 40 levels: 3 }")));
}

/// Where cells coincide, the first word of the definition is the one that is opened.
TEST(Crowded, cells_that_coincide_give_the_same_picture_when_opened_once) {
    const CompiledScene scene = compile_text(square_of_coinciding_cells(12));
    const std::vector<SeenPixel> known = look_at(scene, known_share(scene));
    const std::vector<SeenPixel> every_word = look_at(scene, 0);
    ASSERT_EQ(known.size(), 144U);
    std::uint64_t fewer = 0, more = 0;
    for (std::size_t i = 0; i < known.size(); ++i) {
        EXPECT_EQ(known[i].outcome, every_word[i].outcome);
        EXPECT_EQ(known[i].key, every_word[i].key);
        EXPECT_EQ(known[i].word, every_word[i].word);
        fewer += known[i].tested;
        more += every_word[i].tested;
    }
    EXPECT_LT(2 * fewer, more);
}

/// A native picture in dsp32 is the machine's, which has no memory for an account of cells.
TEST(Crowded, cells_are_opened_in_dsp32_as_on_the_machine) {
    const CompiledScene crowded = compile_text(fat_square(4));
    const std::vector<std::uint32_t> block = make_scene_block<float>(crowded);
    const auto as_machine = make_native_node<NativeNode<dsp32::Float>>(crowded, block);
    EXPECT_FALSE(as_machine.knows_cells());
    EXPECT_EQ(as_machine.heap_capacity(), 256);
    const auto native = make_native_node<NativeNode<float>>(crowded, block);
    EXPECT_TRUE(native.knows_cells());
    EXPECT_EQ(native.heap_capacity(), crowded_heap);
    const CompiledScene plain = compile_text(scene_of("octo", "volume: sphere", "size: 4,4"));
    EXPECT_FALSE(make_native_node<NativeNode<float>>(plain, block).knows_cells());
}

/// That is looked for once: there is a node for every thread.
TEST(Crowded, nodes_go_by_what_compiling_found) {
    CompiledScene scene = compile_text(fat_square(4));
    const std::vector<std::uint32_t> block = make_scene_block<float>(scene);
    ASSERT_TRUE(scene.shapes.at(0).crowded);
    scene.shapes[0].crowded = false;
    EXPECT_FALSE(make_native_node<NativeNode<float>>(scene, block).knows_cells());
}

TEST(KnownCells, a_cell_is_known_if_one_before_it_reached_as_far) {
    KnownCells known;
    CellSketch sketch;
    sketch.add(std::uint64_t{7});
    EXPECT_FALSE(known.contains(sketch, 2.0, 1.0));
    EXPECT_TRUE(known.contains(sketch, 1.0, 1.0));
    EXPECT_FALSE(known.contains(sketch, 3.0, 1.0));
    EXPECT_TRUE(known.contains(sketch, 3.0, 1.0));
    known.forget();
    EXPECT_FALSE(known.contains(sketch, 1.0, 1.0));
}

TEST(KnownCells, no_cell_is_known_by_a_larger_one) {
    KnownCells known;
    CellSketch sketch;
    sketch.add(std::uint64_t{7});
    EXPECT_FALSE(known.contains(sketch, 2.0, 1.0));
    EXPECT_FALSE(known.contains(sketch, 1.0, 0.9));  // as a child that looks like its parent
    EXPECT_TRUE(known.contains(sketch, 1.0, 0.9));
    EXPECT_TRUE(known.contains(sketch, 1.0, 0.95));
    EXPECT_TRUE(known.contains(sketch, 2.0, 1.0));
    EXPECT_FALSE(known.contains(sketch, 2.0, 0.95));  // each was smaller or reached as far
    EXPECT_TRUE(known.contains(sketch, 2.0, 0.97));
}

/// The chain of a map that hardly shrinks looks the same from cell to cell for a hundred levels: a
/// pixel once missed the attractor at its end (seed 54 of tools/oracle).
TEST(KnownCells, what_lies_deep_in_a_map_that_hardly_shrinks_is_found) {
    const CompiledScene scene = compile_text(R"(
        image { size: 26,44 }
        render { lipschitz: product }
        ifs fractal {
            newmap scale: 0.9921713445375967
                translate: -0.004874427543386073,0.006169041984244394,-0.005951266467417948
            newmap scale: 0.10757747943090586
                translate: -0.10102407471079317,-0.4395971075934984,0.3286242970309698
            newmap scale: 0.2383468171402991
                translate: 0.7461268634407586,0.19727770065487846,-0.4423546470961963
            newmap scale: 0.23207665561726787
                translate: -0.1612732224600647,-0.2948688915726546,0.72193172929465
            newmap scale: 0.11985848197815148
                translate: -0.030825889490260838,-0.33505172513605685,-0.6148768789167859
        })");
    ASSERT_TRUE(has_crowded_objects(scene));
    const std::vector<SeenPixel> known = look_at(scene, known_share(scene));
    const std::vector<SeenPixel> every_word = look_at(scene, 0);
    ASSERT_EQ(known.size(), every_word.size());
    for (std::size_t i = 0; i < known.size(); ++i)
        EXPECT_EQ(known[i].outcome, every_word[i].outcome) << i;
}

TEST(KnownCells, what_does_not_fit_is_not_known_and_nothing_else_is_forgotten) {
    KnownCells known;
    const auto sketch = [](std::uint64_t number) {
        CellSketch result;
        result.add(number);
        return result;
    };
    for (std::uint64_t i = 0; i < KnownCells::room + 10; ++i) {
        ASSERT_FALSE(known.contains(sketch(i), 1.0, 1.0));
    }
    EXPECT_TRUE(known.contains(sketch(0), 1.0, 1.0));
    EXPECT_TRUE(known.contains(sketch(KnownCells::room - 1), 1.0, 1.0));
    EXPECT_FALSE(known.contains(sketch(KnownCells::room + 9), 1.0, 1.0));
}

TEST(KnownCells, steps_are_powers_of_two_not_above_what_was_asked_for) {
    EXPECT_EQ(steps_per_unit(1.0), 1);
    EXPECT_EQ(steps_per_unit(1.99), 1);
    EXPECT_EQ(steps_per_unit(0.3), 4);
    EXPECT_EQ(steps_per_unit(1e-30), std::exp2(100));
}

TEST(Crowded, cells_that_cannot_be_remembered_are_warned_of_before_the_first_ray) {
    const CompiledScene crowded = compile_text(fat_square(4));
    EXPECT_EQ(crowd_text(crowded, Numeric::single), "");
    EXPECT_EQ(crowd_text(crowded, Numeric::double_), "");
    const std::string text = crowd_text(crowded, Numeric::dsp32);
    EXPECT_NE(text.find("up to " + std::to_string(crowded.cell_cap)), std::string::npos) << text;
    EXPECT_NE(crowd_text(compile_text(fat_square(4) + "render { covers: area }"), Numeric::single),
              "");
    EXPECT_EQ(crowd_text(compile_text(ifs("octo")), Numeric::dsp32), "");
}

}  // namespace
}  // namespace pxm::test
