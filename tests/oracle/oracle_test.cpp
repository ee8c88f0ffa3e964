// Laws of what the campaign of tools/oracle is made of: the grammar knows all of the language, and
// the oracle can fail. The scenes that it has no fault to find in are in oracle_slow_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <string>

#include "host/scene/check/check.hpp"
#include "host/scene/parse/grammar.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/print/format.hpp"
#include "host/scene/print/print.hpp"
#include "host/scene/words.hpp"
#include "tests/support/campaign/random_system.hpp"
#include "tests/support/campaign/scene_grammar.hpp"
#include "tests/support/campaign/shrink.hpp"
#include "tests/support/campaign/trial.hpp"
#include "tests/support/example_scenes.hpp"

namespace pxm::test {
namespace {

using namespace host;

Scene parsed(const std::string& text, Diagnostics& diagnostics) {
    const auto reader = [](const std::string&) { return SceneGrammar::part_text(); };
    return parse_text("scene.pxm", text, diagnostics, reader);
}

TEST(SceneGrammar, has_a_form_of_every_directive_that_the_parser_knows) {
    std::vector<std::string> directives;
    for (const BlockGrammar& block : all_blocks()) {
        for (const Directive& directive : block.directives)
            directives.push_back(std::string(block.kind) + "." + std::string(directive.word));
    }
    EXPECT_THAT(SceneGrammar(0).known_directives(), testing::UnorderedElementsAreArray(directives));
}

TEST(SceneGrammar, writes_every_directive_every_word_and_every_form_of_a_number) {
    std::string all;
    for (std::uint64_t seed = 0; seed < 300; ++seed) all += SceneGrammar(seed).scene();
    std::set<std::string> expected{"include:", "rifs ", "# a comment", "covers: area",
                                   "covers: on"};
    for (const BlockGrammar& block : all_blocks()) {
        expected.insert(std::string(block.kind) + " ");
        for (const Directive& directive : block.directives)
            expected.insert(std::string(directive.word));
    }
    for (const std::string& sign : NumberForms::all_signs()) expected.insert(sign);
    const auto add_words = [&](const std::string& directive, const auto& words) {
        for (const auto& word : words) expected.insert(directive + ": " + std::string(word.text));
    };
    add_words("shading", shading_words);
    add_words("intersect", intersect_words);
    add_words("numeric", numeric_words);
    add_words("lipschitz", lipschitz_words);
    add_words("volume", volume_words);
    add_words("shadow", switch_words);
    for (const std::string& form : expected) EXPECT_NE(all.find(form), std::string::npos) << form;
}

TEST(SceneGrammar, writes_scenes_without_a_mistake_that_print_and_format_as_themselves) {
    const bool right = rc::check([](std::uint32_t seed) {
        const std::string text = SceneGrammar(seed).scene();
        Diagnostics diagnostics;
        const Scene scene = parsed(text, diagnostics);
        if (!diagnostics.has_errors()) check_scene(scene, diagnostics);
        if (diagnostics.has_errors()) {
            RC_FAIL(diagnostics.text(scene.files) + "\n" + text);
        }
        RC_ASSERT(parsed(print_scene(scene), diagnostics) == scene);
        RC_ASSERT(parsed(format_scene(text), diagnostics) == scene);
        RC_ASSERT(!diagnostics.has_errors());
    });
    EXPECT_TRUE(right);
}

/// The tetra among other things, so that there is something to leave out.
Scene busy_scene() {
    Diagnostics diagnostics;
    Scene scene = parsed(
        ifs("tetra") + ifs("octo") +
            "object a { ifs: tetra color: 1,0,0,0.5 } object b { ifs: octo translate: 2.512,0,0 }"
            "light { direction: 0.3,1,-0.7 } render { shading: low-pass }"
            "camera { eye: 0.123,0.456,-4 look: 0.5,0,0 } image { size: 24,18 }",
        diagnostics);
    EXPECT_FALSE(diagnostics.has_errors());
    return scene;
}

std::size_t maps_of(const Scene& scene) {
    std::size_t maps = 0;
    for (const IfsBlock& block : scene.ifs) maps += block.maps.size();
    return maps;
}

TEST(OracleCampaign, finds_nothing_in_a_scene_that_is_right) {
    const Trial trial = try_scene(busy_scene(), {});
    EXPECT_TRUE(trial.finds.empty()) << trial.finds.front().method << trial.finds.front().what;
    EXPECT_EQ(trial.score.of("finds"), 0);
    EXPECT_GT(trial.score.of("judged: as defined"), 50);
}

/// Each method's picture with one pixel changed, where the change cannot be mistaken for rounding.
TEST(OracleCampaign, finds_one_changed_pixel_in_the_picture_of_each_method) {
    for (const std::string& method : all_methods()) {
        if (method == "print") continue;
        TrialSettings settings;
        settings.spoil = [&](const std::string& made_by, Frame& frame) {
            if (made_by != method) return;
            const auto hit = std::ranges::find_if(
                frame.pixels, [](const PixelRecord& pixel) { return pixel.alpha > 0; });
            if (hit == frame.pixels.end()) {
                frame.pixels.front().word = 1;  // the machine's window may show nothing
            } else {
                hit->word ^= 1U;
            }
        };
        const Trial trial = try_scene(busy_scene(), settings);
        // Others may be compared with the picture that was spoiled, behind it.
        ASSERT_FALSE(trial.finds.empty()) << method;
        EXPECT_EQ(trial.finds.front().method, method);
    }
}

/// A constant of a map is a twentieth too small for the kernels: cells end too early.
TEST(OracleCampaign, finds_a_wrong_constant_and_makes_the_scene_small) {
    TrialSettings settings;
    settings.only = {"double"};
    settings.spoil_scene = [](CompiledScene& scene) {
        for (CompiledMap& map : scene.shapes.front().maps) map.constant *= 0.95;
    };
    const Scene scene = busy_scene();
    const Trial trial = try_scene(scene, settings);
    ASSERT_EQ(trial.finds.size(), 1U);
    const Shrunk small = shrink(scene, trial.finds.front(), settings, 120);
    EXPECT_EQ(small.find.method, "double");
    EXPECT_LE(maps_of(small.scene), 3U) << print_scene(small.scene);
    EXPECT_EQ(small.scene.ifs.size(), 1U);
    EXPECT_TRUE(small.scene.objects.empty());
    EXPECT_TRUE(small.scene.lights.empty());
    const CropWindow crop = small.scene.image->crop.value_or(CropWindow{0, 0, 9, 9});
    EXPECT_EQ(crop.x1 - crop.x0, 1);
    EXPECT_EQ(crop.y1 - crop.y0, 1);
    // It shows the fault by itself, and nothing without it.
    EXPECT_FALSE(try_scene(small.scene, settings).finds.empty());
    settings.spoil_scene = nullptr;
    EXPECT_TRUE(try_scene(small.scene, settings).finds.empty());
}

TEST(OracleCampaign, draws_the_same_scene_from_the_same_seed) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        EXPECT_TRUE(random_system(seed) == random_system(seed));
        EXPECT_EQ(SceneGrammar(seed).scene(), SceneGrammar(seed).scene());
    }
}

}  // namespace
}  // namespace pxm::test
