// Documents lead to one another and to the sources: every document is reached from README.md, what
// documents and comments call by a path or by a file's name is there, the ten numbers of
// docs/performance.md stand in the tables that they are taken from, and the version is one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/tree_texts.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
        found.push_back((*it)[1]);
    return found;
}

/// The documents that a document links to.
std::vector<std::string> linked(const std::string& from, const std::string& text) {
    static const std::regex link(R"(\]\(([^)#\s:]+\.md)(?:#[^)\s]*)?\))");
    std::vector<std::string> documents;
    for (const std::string& target : matches(text, link))
        documents.push_back((fs::path(from).parent_path() / target).lexically_normal().string());
    return documents;
}

/// The documents to which no links lead from README.md.
std::vector<std::string> unreached(const Texts& texts) {
    std::set<std::string> reached{"README.md"};
    std::vector<std::string> waiting{"README.md"};
    while (!waiting.empty()) {
        const std::string document = waiting.back();
        waiting.pop_back();
        for (const std::string& next : linked(document, texts.at(document)))
            if (texts.contains(next) && reached.insert(next).second) waiting.push_back(next);
    }
    std::vector<std::string> left;
    for (const auto& [path, text] : texts)
        if (is_document(path) && !reached.contains(path)) left.push_back(path);
    return left;
}

bool is_cpp(const std::string& path) {
    return path.ends_with(".cpp") || path.ends_with(".hpp") || path.ends_with(".inl");
}

/// What is written for people: a document whole, of all else the comments.
std::string written(const std::string& path, const std::string& text) {
    if (is_document(path)) return text;
    const std::string mark = is_cpp(path) ? "//" : "#";
    std::string comments;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(mark);
        if (at == 0 || (at != std::string::npos && line[at - 1] == ' '))
            comments += line.substr(at) + '\n';
    }
    return comments;
}

/// The words of a text that may be paths or names of files. A pattern would take a hundred times as
/// long to find them.
std::vector<std::string> words_of(const std::string& text) {
    static const std::string others = "_./*-";
    std::vector<std::string> words;
    std::string word;
    for (const char c : text + '\n') {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || others.find(c) < others.size()) {
            word += c;
        } else if (!word.empty()) {
            while (word.ends_with('.') || word.ends_with('-')) word.pop_back();
            words.push_back(word);
            word.clear();
        }
    }
    return words;
}

const std::set<std::string> tops{"pxm",      "dsp_kernels", "host",  "tests", "bench",
                                 "findings", "cmake",       "tools", "docs",  "scenes"};

/// A path from the top of the tree; `host/wide/packet` may stand for a pair of files,
/// `host/wide/tile_*.cpp` for all of that form, and a NAME for any.
bool is_path(const std::string& word) {
    const std::size_t slash = word.find('/');
    return slash != std::string::npos && tops.contains(word.substr(0, slash)) &&
           word.find("NAME") == std::string::npos;
}

/// The name of a C++ file, without a folder. `_test.cpp` is an ending, and `x_test.cpp` stands for
/// any name.
bool is_name(const std::string& word) {
    return is_cpp(word) && word.find_first_of("/*-") == std::string::npos &&
           !word.starts_with('_') && !word.starts_with("x_") && !word.starts_with('.');
}

class Tree {
  public:
    explicit Tree(const std::vector<std::string>& paths) {
        for (const std::string& path : paths) {
            add(path);
            names_.insert(fs::path(path).filename().string());
        }
    }
    [[nodiscard]] bool has_name(const std::string& name) const { return names_.contains(name); }
    [[nodiscard]] bool has(const std::string& path) const {
        if (path.find('*') != std::string::npos) return has_form(path);
        const std::string whole = path.ends_with('/') ? path.substr(0, path.size() - 1) : path;
        return paths_.contains(whole) || paths_.contains(whole + ".hpp") ||
               paths_.contains(whole + ".cpp");
    }

  private:
    void add(const fs::path& path) {
        for (fs::path at = path; !at.empty(); at = at.parent_path()) paths_.insert(at.string());
    }
    [[nodiscard]] bool has_form(const std::string& form) const {
        const auto star = form.find('*');
        const std::string begin = form.substr(0, star);
        const std::string end = form.substr(star + 1);
        return std::ranges::any_of(paths_, [&](const std::string& path) {
            return path.size() >= begin.size() + end.size() && path.starts_with(begin) &&
                   path.ends_with(end);
        });
    }

    std::set<std::string> paths_;  // files and folders
    std::set<std::string> names_;  // of files
};

/// What is named and is not there.
std::vector<std::string> missing(const Tree& tree, const std::string& path,
                                 const std::string& text) {
    std::vector<std::string> complaints;
    for (const std::string& word : words_of(written(path, text)))
        if ((is_path(word) && !tree.has(word)) || (is_name(word) && !tree.has_name(word)))
            complaints.push_back(path + ": no " + word);
    return complaints;
}

Tree tree_on_the_disk() {
    std::vector<std::string> paths;
    for (const std::string& top : tops)
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir) / top))
            paths.push_back(fs::relative(entry.path(), source_dir).generic_string());
    return Tree(paths);
}

TEST(Documents, each_is_reached_from_the_readme) {
    EXPECT_THAT(unreached(texts_of_the_tree()), IsEmpty());
}

TEST(Documents, one_that_nothing_links_to_is_seen) {
    EXPECT_THAT(unreached({{"README.md", "[a](docs/a.md)"},
                           {"docs/a.md", "[b](deeper/b.md#there)"},
                           {"docs/deeper/b.md", "[up](../../README.md)"},
                           {"docs/c.md", "[a](a.md)"}}),
                ElementsAre("docs/c.md"));
}

TEST(Documents, what_is_named_by_its_path_or_name_is_there) {
    const Tree tree = tree_on_the_disk();
    std::vector<std::string> complaints;
    for (const auto& [path, text] : texts_of_the_tree()) {
        if (path == "tests/documents_test.cpp" || path == "tests/citations_test.cpp")
            continue;  // they name what is not there
        const std::vector<std::string> of_this = missing(tree, path, text);
        complaints.insert(complaints.end(), of_this.begin(), of_this.end());
    }
    EXPECT_THAT(complaints, IsEmpty());
}

TEST(Documents, what_is_named_and_not_there_is_seen) {
    const Tree tree({"host/wide/ray.hpp", "host/wide/tile.cpp", "tools/test"});
    EXPECT_THAT(missing(tree, "docs/a.md",
                        "`host/wide/`, `host/wide/ray`, host/wide/ray.hpp, `ray.hpp`, "
                        "`host/wide/t*.cpp`, tools/test."),
                IsEmpty());
    EXPECT_THAT(missing(tree, "docs/a.md",
                        "`host/gone/`, [x](../host/wide/gone.hpp), `host/wide/ray.cpp`, "
                        "`gone.hpp`, `host/wide/g*.cpp`"),
                ElementsAre("docs/a.md: no host/gone/", "docs/a.md: no host/wide/ray.cpp",
                            "docs/a.md: no gone.hpp", "docs/a.md: no host/wide/g*.cpp"))
        << "links are the citations' to check";
    EXPECT_THAT(missing(tree, "pxm/a.cpp", "int x = 1;  // host/gone.cpp\nopen(\"host/b.cpp\");\n"),
                ElementsAre("pxm/a.cpp: no host/gone.cpp"))
        << "of code the comments are read";
}

/// Rows of the table of ten numbers: what it answers, and the document that it is taken from.
struct Answer {
    std::string text;
    std::string document;
};

std::vector<Answer> answers_of(const std::string& page) {
    static const std::regex row(
        R"(^\| [^|]*\? \| ([^|]*) \| `[^|]*` \| \[[^\]]*\]\((measurements/[\w-]+\.md)\) \|$)",
        std::regex::multiline);
    std::vector<Answer> answers;
    for (std::sregex_iterator it(page.begin(), page.end(), row), end; it != end; ++it)
        answers.push_back({(*it)[1], "docs/" + (*it)[2].str()});
    return answers;
}

std::vector<std::string> numbers_in(const std::string& text) {
    static const std::regex number(R"((?:^|[^\w.])(\d+(?:\.\d+)?)(?![\w]))");
    return matches(text, number);
}

TEST(Documents, the_ten_numbers_stand_in_the_tables_that_they_are_taken_from) {
    const Texts texts = texts_of_the_tree();
    const std::vector<Answer> answers = answers_of(texts.at("docs/performance.md"));
    EXPECT_EQ(answers.size(), 10U);
    for (const Answer& answer : answers) {
        ASSERT_TRUE(texts.contains(answer.document)) << answer.document;
        const std::vector<std::string> measured = numbers_in(texts.at(answer.document));
        const std::vector<std::string> shown = numbers_in(answer.text);
        EXPECT_FALSE(shown.empty()) << answer.text;
        for (const std::string& number : shown)
            EXPECT_THAT(measured, testing::Contains(number)) << answer.text;
    }
}

TEST(Documents, name_the_version_that_is_built) {
    const auto first = [](const char* file, const char* pattern) {
        const std::string text = text_of(fs::path(source_dir) / file);
        const std::vector<std::string> found =
            matches(text, std::regex(pattern, std::regex::multiline));
        return found.empty() ? "none" : found[0];
    };
    const std::string built = first("CMakeLists.txt", R"(project\(pxm VERSION ([\d.]+))");
    EXPECT_EQ(first("CITATION.cff", R"(^version: ([\d.]+)$)"), built);
    EXPECT_EQ(first("CHANGELOG.md", R"(^## \[(\d[\d.]*)\] - \d{4}-\d\d-\d\d$)"), built);
}

}  // namespace
}  // namespace pxm::test
