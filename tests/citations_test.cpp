// Documents and code cite what exists: documents, their sections, the decisions of docs/design.md,
// errata, and the sources of docs/references.md. The rules are a function of paths and texts, so
// that the tests can show that it sees what is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/paths.hpp"
#include "tests/support/tree_texts.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using Complaints = std::vector<std::string>;

/// The text of a file of code with its comments' lines joined: a citation may go over a line's end.
std::string joined(const std::string& text) {
    std::string line;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] != '\n') {
            line += text[at];
            continue;
        }
        while (at + 1 < text.size() && (text[at + 1] == ' ' || text[at + 1] == '/')) ++at;
        line += ' ';
    }
    return line;
}

struct Heading {
    std::string title;
    std::string anchor;  // as GitHub makes it of the title
};

std::string anchor_of(const std::string& title) {
    std::string anchor;
    for (const char c : title) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
            anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (c == ' ')
            anchor += '-';
    }
    return anchor;
}

std::vector<Heading> headings_of(const std::string& text) {
    std::vector<Heading> headings;
    std::istringstream lines(text);
    bool fenced = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) fenced = !fenced;
        const std::size_t level = line.find_first_not_of('#');
        if (fenced || level == 0 || level == std::string::npos || line[level] != ' ') continue;
        headings.push_back({line.substr(level + 1), anchor_of(line.substr(level + 1))});
    }
    return headings;
}

/// What a citation points into.
class Library {
  public:
    explicit Library(const Texts& files) : files_(files) {
        for (const auto& [path, text] : files)
            if (is_document(path)) headings_[path] = headings_of(text);
    }
    [[nodiscard]] bool has_document(const std::string& path) const {
        return headings_.contains(path);
    }
    [[nodiscard]] bool has_title(const std::string& document, const std::string& begin) const {
        return any(document, [&](const Heading& h) { return h.title.starts_with(begin); });
    }
    [[nodiscard]] bool has_anchor(const std::string& document, const std::string& anchor) const {
        return any(document, [&](const Heading& h) { return h.anchor == anchor; });
    }
    [[nodiscard]] bool says(const std::string& document, const std::string& words) const {
        const auto file = files_.find(document);
        return file != files_.end() && file->second.find(words) != std::string::npos;
    }

  private:
    template <class Test>
    [[nodiscard]] bool any(const std::string& document, const Test& test) const {
        const auto found = headings_.find(document);
        return found != headings_.end() && std::ranges::any_of(found->second, test);
    }
    const Texts& files_;
    std::map<std::string, std::vector<Heading>> headings_;
};

/// Calls `see(match)` for the pattern wherever `word` stands. A plain search first: it is a hundred
/// times as fast as a pattern on a whole tree.
template <class See>
void each(const std::string& text, const std::string& word, const std::regex& pattern,
          const See& see) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        std::smatch match;
        const auto from = text.begin() + static_cast<std::ptrdiff_t>(at);
        const auto to = text.begin() + static_cast<std::ptrdiff_t>(std::min(text.size(), at + 200));
        if (std::regex_search(from, to, match, pattern, std::regex_constants::match_continuous))
            see(match);
    }
}

/// Names a place in a book, which is no section of a document of ours.
bool is_place(const std::string& words) {
    static const std::regex place("(Alg|App|Ch|Def|Eq|Errat(um|a)|Fig|Sec|Theorem)\\b.*");
    return std::regex_match(words, place);
}

/// What is wrong with the citations of one text.
class Reader {
  public:
    Reader(const Library& library, const std::string& path, Complaints& complaints)
        : library_(library), path_(path), complaints_(complaints) {}

    void read(const std::string& text) {
        documents_by_path(text);
        documents_by_name(text);
        decisions(text);
        errata(text);
        sources(text);
        if (is_document(path_)) links(text);
    }

  private:
    void expect(bool holds, const std::string& what) {
        if (!holds) complaints_.push_back(path_ + ": no " + what);
    }

    void documents_by_path(const std::string& text) {
        static const std::regex cited(
            R"re(docs/((?:[\w-]+/)*[\w-]+)\.md(?:,? "([^"]+)"|, Sec\. (\d+)|, ([A-Z`][^.,;:()\n]*))?)re");
        each(text, "docs/", cited, [&](const std::smatch& match) {
            const auto at = match[0].first - text.begin();
            // Another project's, or a link, which is read below.
            if (at > 0 && text[static_cast<std::size_t>(at) - 1] == '/') return;
            const std::string document = "docs/" + match[1].str() + ".md";
            section(document, match[2]);
            if (match[3].matched) section(document, match[3].str() + ". ");
            // Without quotes nobody can tell where a section's name ends.
            if (match[4].matched && !is_place(match[4]))
                expect(false, "quotes around the section " + match[4].str());
        });
    }

    void documents_by_name(const std::string& text) {
        for (const std::string name : {"machine-facts", "thesis-notes"}) {
            const std::regex cited(name + R"re((?:,? (?:"([^"]+)"|Sec\. (\d+)))?)re");
            each(text, name, cited, [&](const std::smatch& match) {
                const std::string document = "docs/" + name + ".md";
                section(document, match[1]);
                if (match[2].matched) section(document, match[2].str() + ". ");
            });
        }
    }

    void section(const std::string& document, const std::string& title) {
        expect(library_.has_document(document), document);
        if (!title.empty())
            expect(library_.has_title(document, title), document + ", \"" + title + "\"");
    }

    void decisions(const std::string& text) {
        static const std::regex cited(R"(decisions? (\d+)((?:, \d+)*)((?: and \d+)?))");
        static const std::regex number(R"(\d+)");
        each(text, "decision", cited, [this](const std::smatch& match) {
            const std::string all = match.str();
            for (std::sregex_iterator it(all.begin(), all.end(), number), end; it != end; ++it)
                expect(library_.has_title("docs/design.md", "Decision " + it->str() + ": "),
                       "decision " + it->str() + " in docs/design.md");
        });
    }

    void errata(const std::string& text) {
        static const std::regex cited(R"(Errat(?:um|a) (\d+))");
        each(text, "Errat", cited, [this](const std::smatch& match) {
            expect(library_.says("docs/thesis-errata.md", "\n| " + match[1].str() + " | "),
                   "erratum " + match[1].str() + " in docs/thesis-errata.md");
        });
    }

    void sources(const std::string& text) {
        static const std::regex cited(R"(\[([A-Z][A-Za-z+]*\d{2,}|S\d{1,2})(?: [\d.]+)?\](?!\())");
        // Letter by letter: code has very many brackets, few with a capital behind them.
        for (char letter = 'A'; letter <= 'Z'; ++letter)
            each(text, std::string("[") + letter, cited, [this](const std::smatch& match) {
                const std::string key = match[1];
                expect(library_.says("docs/references.md", "`[" + key + "]`") ||
                           library_.says("docs/references.md", "| " + key + " | "),
                       "source [" + key + "] in docs/references.md");
            });
    }

    void links(const std::string& text) {
        static const std::regex link(R"(\]\(([^)#\s]*)(?:#([^)\s]+))?\))");
        each(text, "](", link, [this](const std::smatch& match) {
            const std::string target = match[1];
            if (target.find("://") != std::string::npos) return;
            const std::string file =
                target.empty()
                    ? path_
                    : (fs::path(path_).parent_path() / target).lexically_normal().string();
            if (is_document(file))
                expect(library_.has_document(file), file);
            else
                expect(fs::exists(fs::path(source_dir) / file), file);
            if (match[2].matched)
                expect(library_.has_anchor(file, match[2]), file + "#" + match[2].str());
        });
    }

    const Library& library_;
    const std::string& path_;
    Complaints& complaints_;
};

Complaints check(const Texts& files) {
    const Library library(files);
    Complaints complaints;
    for (const auto& [path, text] : files)
        Reader(library, path, complaints).read(is_document(path) ? text : joined(text));
    return complaints;
}

/// What is said of a file in a tree of six small documents.
Complaints complaints_about(const std::string& path, const std::string& text) {
    return check({{"docs/design.md", "# The design\n## Decision 4: the picture\n"},
                  {"docs/thesis-notes.md", "# Notes\n## After the thesis\n"},
                  {"docs/machine-facts.md", "# Facts\n## 6. Costs of operations\n"},
                  {"docs/measurements/heaps.md", "# How much a heap costs\n"},
                  {"docs/thesis-errata.md", "# Errata\n| 3 | Alg. 12.4 | x |\n"},
                  {"docs/references.md", "# References\n| `[PH89]` | S4 | x |\n"},
                  {path, text}});
}

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(Citations, the_tree_cites_what_exists) {
    Texts files = texts_of_the_tree();
    for (const char* cites_what_is_not_there : {"citations", "documents"})
        files.erase(std::string("tests/") + cites_what_is_not_there + "_test.cpp");
    ASSERT_GT(files.size(), 400U);
    EXPECT_THAT(check(files), IsEmpty());
}

TEST(Citations, a_decision_stands_in_the_design) {
    EXPECT_THAT(complaints_about("pxm/a.hpp", "// design decision 4\n"), IsEmpty());
    EXPECT_THAT(complaints_about("pxm/a.hpp", "// design decision 44\n"),
                ElementsAre("pxm/a.hpp: no decision 44 in docs/design.md"));
    EXPECT_THAT(complaints_about("pxm/a.hpp", "// docs/design.md, decisions 1, 4 and 9\n"),
                SizeIs(2));
}

TEST(Citations, a_document_and_its_section_exist) {
    for (const std::string comment :
         {"// docs/thesis-notes.md", "// thesis-notes, \"After the\n// thesis\"",
          "// machine-facts, Sec. 6", "// docs/thesis-notes.md, \"After the thesis\"",
          "// docs/machine-facts.md, Sec. 6", "// docs/measurements/heaps.md, \"How\"",
          "// docs/thesis-errata.md, Erratum 3", "// docs/design.md, which says so"})
        EXPECT_THAT(complaints_about("host/a.cpp", comment + '\n'), IsEmpty()) << comment;
    for (const std::string comment :
         {"// docs/gone.md", "// thesis-notes, \"Before the\n// thesis\"",
          "// machine-facts, Sec. 7", "// docs/thesis-notes.md, \"Gone\"",
          "// docs/machine-facts.md, Sec. 7", "// docs/measurements/gone.md",
          "// docs/thesis-notes.md, After the thesis", "// docs/design.md, `picture`"})
        EXPECT_THAT(complaints_about("host/a.cpp", comment + '\n'), SizeIs(1)) << comment;
}

TEST(Citations, a_link_has_a_target_and_its_anchor_a_heading) {
    for (const std::string link : {"[a](design.md)", "[a](design.md#decision-4-the-picture)",
                                   "[a](#here)", "[a](machine-facts.md#6-costs-of-operations)",
                                   "[a](https://example.org/b.md#c)", "[a](../scenes/tetra.pxm)"})
        EXPECT_THAT(complaints_about("docs/b.md", "# Here\n" + link), IsEmpty()) << link;
    for (const std::string link : {"[a](gone.md)", "[a](design.md#gone)", "[a](#gone)",
                                   "[a](../scenes/gone.pxm)", "![a](pictures/gone.png)"})
        EXPECT_THAT(complaints_about("docs/b.md", "# Here\n" + link), SizeIs(1)) << link;
}

TEST(Citations, an_erratum_and_a_source_are_listed) {
    EXPECT_THAT(complaints_about("host/a.cpp", "// Erratum 3, [PH89], [S4], [PH89 2.1]\n"),
                IsEmpty());
    EXPECT_THAT(complaints_about("host/a.cpp", "// Erratum 33, [PH88], [S5]\n"), SizeIs(3));
}

}  // namespace
}  // namespace pxm::test
