// A short campaign: random systems and scenes of the grammar, judged as tools/oracle does without
// end; and what only the program shows, that a scene and its print give the same bytes.
#include <gtest/gtest.h>

#include <string>

#include "host/scene/parse/parser.hpp"
#include "host/scene/print/print.hpp"
#include "tests/support/campaign/random_system.hpp"
#include "tests/support/campaign/scene_grammar.hpp"
#include "tests/support/campaign/trial.hpp"
#include "tests/support/command.hpp"
#include "tests/support/folder.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr std::uint64_t systems = 60, grammar_scenes = 30, printed = 16;

void expect_no_find(const Scene& scene, std::uint64_t seed, Score& score) {
    TrialSettings settings;
    settings.seed = seed;
    settings.cell_cap = 4'000;
    settings.patience = 12'000;
    const Trial trial = try_scene(scene, settings);
    for (const Find& find : trial.finds) {
        ADD_FAILURE() << "seed " << seed << ", " << find.method << " at " << find.x << "," << find.y
                      << ": " << find.what << "\n"
                      << print_scene(scene);
    }
    score.add(trial.score);
}

TEST(OracleCampaignSlow, finds_nothing_in_random_systems) {
    Score score;
    for (std::uint64_t seed = 1; seed <= systems; ++seed)
        expect_no_find(random_system(seed), seed, score);
    EXPECT_GT(score.of("judged: as defined"), 1000);
    EXPECT_GT(score.of("same in every bit"), 1000);
}

class GrammarScene : public testing::Test {
  protected:
    GrammarScene() {
        folder_.write(SceneGrammar::part_file, SceneGrammar::part_text());
        folder_.write(SceneGrammar::picture_file, SceneGrammar::picture_bytes());
    }
    [[nodiscard]] Scene parsed(const std::string& text) const {
        Diagnostics diagnostics;
        Scene scene = parse_scene(folder_.path("scene.pxm"), diagnostics, {}, nullptr, text);
        EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.text(scene.files) << text;
        return scene;
    }
    Folder folder_;
};

TEST_F(GrammarScene, is_rendered_by_every_engine_without_a_find) {
    Score score;
    for (std::uint64_t seed = 1; seed <= grammar_scenes; ++seed)
        expect_no_find(parsed(SceneGrammar(seed).scene()), seed, score);
    EXPECT_EQ(score.of("scenes refused"), 0);
    EXPECT_GT(score.of("judged: as defined"), 500);
}

TEST_F(GrammarScene, has_the_bytes_of_its_print) {
    for (std::uint64_t seed = 1; seed <= printed; ++seed) {
        const std::string text = SceneGrammar(seed).scene();
        const Scene scene = parsed(text);
        // The print is of one moment; while a shutter is open there are several.
        if (scene.animation && scene.animation->shutter > 0) continue;
        folder_.write("scene.pxm", text);
        folder_.write("print.pxm", print_scene(scene));
        for (const char* name : {"scene", "print"}) {
            const std::string file = std::string(name) + ".pxm";
            const std::string picture = std::string(name) + ".png";
            expect_done(folder_, {"render", file, "--no-scene", "-o", picture});
        }
        EXPECT_EQ(folder_.read("scene.png"), folder_.read("print.png")) << text;
    }
}

}  // namespace
}  // namespace pxm::test
