// Every command of scenes/README.md draws its picture, from the top of the tree; here in a few
// pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

/// The words of a command, small: its size, window and number of samples are left out, and of its
/// frames there is the first. What is a path from the top of the tree is given whole.
Arguments small(const std::string& command) {
    std::istringstream words(command);
    Arguments arguments;
    for (std::string word; words >> word;) {
        if (word == "--size" || word == "--crop" || word == "--samples" || word == "-o") {
            words >> word;
        } else if (word == "--frames") {
            words >> word;
            arguments.insert(arguments.end(), {"--frames", "0"});
        } else {
            arguments.push_back(word);
        }
    }
    for (std::string& word : arguments)
        if (fs::exists(fs::path(source_dir) / word)) word = source_dir + "/" + word;
    arguments.insert(arguments.end(), {"--size", "12x10", "--samples", "1", "-o", "out.png"});
    return arguments;
}

TEST(Gallery, every_command_of_the_page_draws_a_picture) {
    const std::string page = text_of(fs::path(source_dir) / "scenes/README.md");
    const std::string start = "`./tools/pxm ";
    int drawn = 0;
    for (std::size_t at = page.find(start); at != std::string::npos;
         at = page.find(start, at + 1)) {
        const std::size_t from = at + start.size();
        const std::string command = page.substr(from, page.find('`', from) - from);
        if (command.find("FILE") != std::string::npos) continue;
        const Folder folder;
        const Outcome outcome = run_program(folder, small(command));
        EXPECT_EQ(outcome.exit_code, 0) << command << '\n' << outcome.err;
        EXPECT_TRUE(folder.has("out.png")) << command;
        ++drawn;
    }
    EXPECT_GT(drawn, 20);
}

}  // namespace
}  // namespace pxm::test
