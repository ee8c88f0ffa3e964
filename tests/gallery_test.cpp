// The pictures of README.md and scenes/README.md are those of scenes/gallery.txt, and the commands
// below them run from the top of the tree.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

std::string tree_text(const std::string& path) { return text_of(fs::path(source_dir) / path); }

/// The scenes that a document's commands draw: `./tools/pxm render PATH ...`.
std::vector<std::string> scenes_of(const std::string& document) {
    static const std::regex command(R"(\./tools/pxm render (\S+\.pxm))");
    std::vector<std::string> scenes;
    for (std::sregex_iterator it(document.begin(), document.end(), command), end; it != end; ++it)
        scenes.push_back((*it)[1]);
    return scenes;
}

TEST(Gallery, every_command_names_a_scene_from_the_top_of_the_tree) {
    for (const char* document : {"README.md", "scenes/README.md"}) {
        const std::vector<std::string> scenes = scenes_of(tree_text(document));
        EXPECT_GE(scenes.size(), 2U) << document;
        for (const std::string& scene : scenes)
            EXPECT_TRUE(fs::exists(fs::path(source_dir) / scene)) << document << ": " << scene;
    }
}

TEST(Gallery, the_page_shows_the_pictures_and_commands_of_the_list) {
    const std::string page = tree_text("scenes/README.md");
    std::istringstream list(tree_text("scenes/gallery.txt"));
    const std::regex entry(R"((\S+) \| (.*?)(?: --enlarge \d+)? \| (.*))");
    std::size_t pictures = 0;
    for (std::string line; std::getline(list, line);) {
        std::smatch match;
        if (line.starts_with('#') || !std::regex_match(line, match, entry)) continue;
        ++pictures;
        const std::string name = match[1];
        const std::string text = match[3];
        EXPECT_NE(page.find("![" + text + "](gallery/" + name + ".png)<br>" + text +
                            "<br>`./tools/pxm render " + match[2].str() + "`"),
                  std::string::npos)
            << line << ": run tools/gallery";
    }
    EXPECT_EQ(pictures, scenes_of(page).size());
}

}  // namespace
}  // namespace pxm::test
