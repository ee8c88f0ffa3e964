// A table of a document is shown as one: a head, a line of dashes, and rows of as many columns.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

long columns(const std::string& row) {
    long bars = 0;
    for (std::size_t i = 0; i < row.size(); ++i)
        if (row[i] == '|' && (i == 0 || row[i - 1] != '\\')) ++bars;
    return bars - 1;
}

bool is_dashes(const std::string& row) {
    return row.starts_with("|") && row.find_first_not_of("|-: ") == std::string::npos;
}

/// Lines that begin a table without a head, or have another number of columns than it.
std::vector<int> broken_rows(const std::string& text) {
    std::vector<int> broken;
    std::istringstream lines(text);
    std::string head;
    bool fenced = false;
    int row = 0;  // of the table that the line is in
    int number = 1;
    for (std::string line; std::getline(lines, line); ++number) {
        if (line.starts_with("```")) fenced = !fenced;
        row = !fenced && line.starts_with("|") ? row + 1 : 0;
        if (row == 1) head = line;
        if ((row == 2) != (row > 0 && is_dashes(line)) ||
            (row > 0 && columns(line) != columns(head)))
            broken.push_back(number);
    }
    return broken;
}

TEST(DocsTables, every_table_has_a_head_and_its_columns) {
    std::vector<fs::path> documents{fs::path(source_dir) / "README.md",
                                    fs::path(source_dir) / "scenes/README.md"};
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir) / "docs"))
        if (entry.path().extension() == ".md") documents.push_back(entry.path());
    for (const fs::path& document : documents)
        EXPECT_EQ(broken_rows(text_of(document)), std::vector<int>{}) << document;
}

TEST(DocsTables, a_broken_table_is_seen) {
    EXPECT_TRUE(broken_rows("| a | b |\n| --- | --: |\n| c \\| d | e |\n").empty());
    EXPECT_EQ(broken_rows("| a | b |\n| --- | --- |\n| c | d |\n\n| e | f |\n| g | h |\n"),
              std::vector<int>{6})
        << "a blank line ends a table: the next one has no dashes";
    EXPECT_EQ(broken_rows("| a | b |\n| --- | --- |\n| c |\n"), std::vector<int>{3});
}

}  // namespace
}  // namespace pxm::test
