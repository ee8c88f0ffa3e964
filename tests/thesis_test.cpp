// docs/thesis.md is true: its files and functions exist, and no citation in the code lacks a row.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

std::string text_at(const fs::path& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<std::string> all_matches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) {
        found.push_back((*at)[1].str());
    }
    return found;
}

const std::regex citation(R"(((?:Alg\.|Eq\.|Def\.|Theorem) [0-9]+\.[0-9]+))");

std::set<std::string> cited_in(const std::string& text) {
    const auto found = all_matches(text, citation);
    return {found.begin(), found.end()};
}

std::set<std::string> cited_by_code() {
    std::set<std::string> cited;
    for (const char* folder : {"pxm", "dsp_kernels", "host"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir) / folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".hpp" || extension == ".cpp") cited.merge(cited_in(text_at(entry)));
        }
    }
    return cited;
}

const std::string page = text_at(fs::path(source_dir) / "docs/thesis.md");

TEST(Thesis, every_citation_of_the_code_has_a_row) {
    const std::set<std::string> rows = cited_in(page);
    const std::set<std::string> cited = cited_by_code();
    EXPECT_GT(cited.size(), 20U);
    for (const std::string& place : cited) EXPECT_TRUE(rows.contains(place)) << place;
}

TEST(Thesis, every_file_of_the_index_exists) {
    const auto files = all_matches(page, std::regex(R"(`((?:pxm|dsp_kernels|host|tests)/[^`]+)`)"));
    EXPECT_GT(files.size(), 40U);
    for (const std::string& file : files) {
        EXPECT_TRUE(fs::exists(fs::path(source_dir) / file)) << file;
    }
}

TEST(Thesis, every_function_of_the_index_stands_in_its_file) {
    const std::regex named(R"(`([a-z_0-9/]+\.[ch]pp`: `[A-Za-z_:]+)`)");
    const auto pairs = all_matches(page, named);
    EXPECT_GT(pairs.size(), 15U);
    for (const std::string& pair : pairs) {
        const std::size_t split = pair.find("`: `");
        const std::string file = pair.substr(0, split);
        const std::string function = pair.substr(split + 4);
        EXPECT_NE(text_at(fs::path(source_dir) / file).find(function), std::string::npos) << pair;
    }
}

TEST(Thesis, a_missing_row_would_be_seen) {
    EXPECT_EQ(cited_in("// Eq. 99.1 and Alg. 12.4"),
              (std::set<std::string>{"Alg. 12.4", "Eq. 99.1"}));
    EXPECT_FALSE(cited_in(page).contains("Eq. 99.1"));
}

}  // namespace
}  // namespace pxm::test
