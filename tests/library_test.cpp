// Laws of pxm as a library: what a program that links it may do, and what it does not bring along.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include "host/render/render.hpp"
#include "host/scene/parse/parser.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr const char* corners_text = R"(
ifs tetra {
    newmap scale: 0.5 translate: 0,0.5,0
    newmap scale: 0.5 translate: 0,-0.5,-0.5
    newmap scale: 0.5 translate: 0.5,-0.5,0.5
    newmap scale: 0.5 translate: -0.5,-0.5,0.5
}
)";

RenderRequest small_request(int threads = 1) {
    RenderRequest request;
    request.overrides.size = PixelSize{64, 64};
    request.threads = threads;
    return request;
}

TEST(Library, the_example_in_the_documents_shows_what_the_text_of_its_system_shows) {
    const RenderResult expected = render_text(corners_text, small_request());
    const float depth = expected.frame.at(32, 32).z;
    ASSERT_TRUE(std::isfinite(depth));
    const Folder folder;
    const std::string example = binary.substr(0, binary.rfind('/')) + "/one_pixel";
    const Outcome run = Process(folder, example, {}, {}).wait(60);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, std::to_string(depth) + "\n");
}

TEST(Library, the_example_that_changes_a_map_shows_both_scenes_and_ends_a_render) {
    const Folder folder;
    const std::string example = binary.substr(0, binary.rfind('/')) + "/change_a_map";
    const Outcome run = Process(folder, example, {}, {}).wait(300);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, testing::HasSubstr("\r100 %"));
    static const std::regex told(
        R"re(before: (\d+) hits, (\d+) with words, some face the eye\n)re"
        R"re(after: (\d+) hits, (\d+) with words, some face the eye\nstopped\n)re");
    std::smatch parts;
    ASSERT_TRUE(std::regex_match(run.out, parts, told)) << run.out;
    EXPECT_EQ(parts[1], parts[2]);
    EXPECT_LT(std::stol(parts[3]), std::stol(parts[1])) << "a smaller map covers less";
}

TEST(Library, a_scene_as_data_is_rendered_as_its_text) {
    Diagnostics diagnostics;
    RenderRequest request = small_request();
    request.scene = parse_text("corners", corners_text, diagnostics);
    ASSERT_FALSE(diagnostics.has_errors());
    const RenderResult result = render(request, {});
    EXPECT_TRUE(same_picture(result.frame, render_text(corners_text, small_request()).frame));
}

TEST(Library, an_error_is_a_kind_with_places) {
    try {
        (void)render_text("ifs a { newmap scale: 2 }\nifs b { newmap scale: 0.5 }\nplane q { z: }",
                          small_request());
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        ASSERT_FALSE(error.mistakes().empty());
        for (const Mistake& mistake : error.mistakes()) {
            EXPECT_EQ(mistake.file, "scene.pxm");
            EXPECT_EQ(mistake.line, 3);
            EXPECT_THAT(error.what(), testing::HasSubstr(mistake.message));
        }
    }
}

TEST(Library, mistakes_of_a_scene_as_data_are_errors_too) {
    RenderRequest request = small_request();
    request.scene.emplace().ifs.resize(1);
    request.scene->ifs[0].name = "empty";
    try {
        (void)render(request, {});
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        EXPECT_THAT(error.what(), testing::HasSubstr("has no maps"));
    }
}

TEST(Library, renders_at_the_same_time_in_one_process_do_not_know_of_each_other) {
    const std::vector<std::string> texts{
        corners_text, tetra_text,
        std::string(corners_text) + "object tetra { ifs: tetra }\nrender { samples: 4 }\n"};
    std::vector<Frame> alone, together(texts.size());
    for (const std::string& text : texts)
        alone.push_back(render_text(text, small_request(2)).frame);
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < texts.size(); ++i) {
            threads.emplace_back([&, i] {
                for (int again = 0; again < 3; ++again)
                    together[i] = render_text(texts[i], small_request(2)).frame;
            });
        }
    }
    for (std::size_t i = 0; i < texts.size(); ++i)
        EXPECT_TRUE(same_picture(alone[i], together[i])) << texts[i];
}

/// The files that one file of the tree includes, and what those include; outside ones in <>.
void add_included(const std::string& path, std::set<std::string>& all) {
    if (!all.insert(path).second) return;
    std::ostringstream text;
    text << std::ifstream(source_dir + "/" + path).rdbuf();
    const std::string code = text.str();
    static const std::regex line(R"re(#include\s*(?:"([^"]+)"|(<[^>]+>)))re");
    for (std::sregex_iterator it(code.begin(), code.end(), line), end; it != end; ++it) {
        if ((*it)[1].matched) {
            add_included((*it)[1], all);
        } else {
            all.insert((*it)[2]);
        }
    }
}

TEST(Library, its_headers_bring_no_heavy_library_along) {
    for (const char* header :
         {"host/render/render.hpp", "host/engine/engine.hpp", "host/inspect/inspection.hpp",
          "host/fractal/bounds/bounds.hpp", "host/fractal/dimension/dimension.hpp",
          "host/fractal/measure/chaos_game.hpp", "host/output/image.hpp", "pxm/machine.hpp"}) {
        std::set<std::string> included;
        add_included(header, included);
        ASSERT_GT(included.size(), 2U) << header;
        for (const std::string& file : included) {
            EXPECT_THAT(file, testing::Not(testing::MatchesRegex(
                                  "<(CLI|nlohmann|OpenImageIO|Eigen|boost|hwy|fmt)/.*|<omp.h>")))
                << header;
        }
    }
}

TEST(Library, mathematics_is_compiled_without_scenes_files_or_machines) {
    for (const char* header :
         {"host/fractal/system/contraction.hpp", "host/fractal/bounds/bounds.hpp",
          "host/fractal/dimension/dimension.hpp"}) {
        std::set<std::string> included;
        add_included(header, included);
        for (const std::string& file : included) {
            EXPECT_THAT(file, testing::MatchesRegex("host/(math|fractal)/.*|<.*>")) << header;
        }
    }
}

}  // namespace
}  // namespace pxm::test
