// docs/tour.md is true: its commands, run one after another in one folder, print what stands below
// them.
#include <gtest/gtest.h>

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

struct Step {
    std::string commands;
    std::string printed;
};

/// The blocks fenced as ```sh, each with the block fenced as ```text that follows it, if one does.
std::vector<Step> steps_of(const std::string& page) {
    std::vector<Step> steps;
    std::istringstream lines(page);
    std::string* open = nullptr;
    std::string other;  // takes blocks of other kinds
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```") && open != nullptr) {
            open = nullptr;
        } else if (line == "```sh") {
            open = &steps.emplace_back().commands;
        } else if (line.starts_with("```")) {
            open = line == "```text" && !steps.empty() ? &steps.back().printed : &other;
        } else if (open != nullptr) {
            *open += line + '\n';
        }
    }
    return steps;
}

/// What a shell prints, on both streams, in that folder and with pxm in its path.
std::string run(const Folder& folder, const std::string& commands) {
    return run_shell(folder, "PATH=$(dirname \"$PXM\"):$PATH\nexec 2>&1\n" + commands).out;
}

TEST(Tour, its_commands_print_what_stands_below_them) {
    const Folder folder;
    fs::create_directory_symlink(fs::path(source_dir) / "scenes", folder.path("scenes"));
    const std::vector<Step> steps = steps_of(text_of(fs::path(source_dir) / "docs/tour.md"));
    EXPECT_GE(steps.size(), 8U);
    for (const Step& step : steps) {
        EXPECT_FALSE(step.printed.empty()) << step.commands;
        EXPECT_EQ(run(folder, step.commands), step.printed) << step.commands;
    }
}

TEST(Tour, a_block_of_commands_is_read_with_what_it_prints) {
    const std::vector<Step> steps =
        steps_of("```\nx\n```\n```sh\na\nb\n```\ntext\n\n```text\nc\n```\n```sh\nd\n```\n");
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_EQ(steps[0].commands, "a\nb\n");
    EXPECT_EQ(steps[0].printed, "c\n");
    EXPECT_EQ(steps[1].printed, "");
}

}  // namespace
}  // namespace pxm::test
