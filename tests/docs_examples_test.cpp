// Every example of a scene in README.md and docs/ (a block fenced as ```pxm) is a scene without
// mistakes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

struct Example {
    std::string place;  // file:line of the fence
    std::string text;
};

std::vector<Example> examples_in(const fs::path& path) {
    std::vector<Example> examples;
    std::ifstream file(path);
    std::string line;
    bool inside = false;
    for (int number = 1; std::getline(file, line); ++number) {
        if (inside && line.starts_with("```")) {
            inside = false;
        } else if (inside) {
            examples.back().text += line + '\n';
        } else if (line == "```pxm") {
            inside = true;
            std::ostringstream place;
            place << path.filename().string() << ':' << number;
            examples.push_back({place.str(), {}});
        }
    }
    EXPECT_FALSE(inside) << path << ": a fence is not closed";
    return examples;
}

std::vector<Example> all_examples() {
    std::vector<Example> examples = examples_in(fs::path(source_dir) / "README.md");
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir) / "docs"))
        if (entry.path().extension() == ".md")
            for (Example& example : examples_in(entry.path()))
                examples.push_back(std::move(example));
    return examples;
}

TEST(DocsExamples, the_scene_language_is_documented_by_examples) {
    EXPECT_GE(examples_in(fs::path(source_dir) / "docs" / "scene-language.md").size(), 8U);
}

TEST(DocsExamples, the_readme_shows_the_scene_of_its_picture_in_six_lines) {
    const std::vector<Example> shown = examples_in(fs::path(source_dir) / "README.md");
    ASSERT_EQ(shown.size(), 1U);
    EXPECT_EQ(std::ranges::count(shown[0].text, '\n'), 6);
    const std::string file = text_of(fs::path(source_dir) / "scenes/fir.pxm");
    EXPECT_EQ(file.substr(file.find('\n') + 1), shown[0].text) << "below its first comment";
}

TEST(DocsExamples, every_example_is_a_scene_without_mistakes) {
    // An example may include "parts.pxm", a file with an ifs named `part`.
    const host::FileReader reader = [](const std::string&) -> std::string {
        return "ifs part { newmap scale: 0.5 }";
    };
    for (const Example& example : all_examples()) {
        host::Diagnostics diagnostics;
        const host::Scene scene =
            host::parse_text(example.place, example.text, diagnostics, reader);
        if (!diagnostics.has_errors()) host::check_scene(scene, diagnostics);
        EXPECT_EQ(diagnostics.text(scene.files), "");
    }
}

}  // namespace
}  // namespace pxm::test
