// Laws of completion: what may stand next on a command line. tests/completion/run asks the shells.
#include "host/commands/completion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "host/commands/cmd.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::UnorderedElementsAre;

/// The words offered; lines that ask the shell for files as they are.
std::vector<std::string> offered(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        words.push_back(line.substr(0, line.find('\t')));
    return words;
}

class Completion : public testing::Test {
  protected:
    /// Of `pxm WORDS`, the last of which is begun.
    [[nodiscard]] std::vector<std::string> after(const Arguments& words) const {
        Arguments asked{"completion", "words", "--"};
        asked.insert(asked.end(), words.begin(), words.end());
        const Outcome told = run(folder, asked);
        EXPECT_EQ(told.exit_code, 0) << told.err;
        EXPECT_EQ(told.err, "");
        return offered(told.out);
    }
    Folder folder;
};

TEST_F(Completion, offers_commands_first) {
    EXPECT_THAT(after({""}), IsSupersetOf({"render", "join", "check", "inspect", "points", "import",
                                           "compare", "study", "models", "asm", "completion"}));
    EXPECT_THAT(after({""}), Not(Contains("manual")));
    EXPECT_THAT(after({"co"}), UnorderedElementsAre("compare", "completion"));
    EXPECT_THAT(after({"--v"}), ElementsAre("--version"));
    EXPECT_EQ(after({}), after({""}));
}

TEST_F(Completion, offers_every_option_of_a_command_by_its_long_name) {
    host::CommandLine line("pxm", "", "");
    const auto commands = host::add_commands(line);
    for (const host::CommandFacts& command : line.facts()) {
        if (command.name.empty()) continue;
        const std::vector<std::string> words = after({command.name, "-"});
        for (const host::OptionFacts& option : command.options)
            if (!option.is_argument) {
                EXPECT_THAT(words, Contains(option.names.back()));
            }
    }
    EXPECT_THAT(after({"render", "tetra", "--sha"}), ElementsAre("--shading"));
}

TEST_F(Completion, offers_the_values_of_an_option) {
    const auto shadings = ElementsAre("constant", "low-pass", "high-pass", "facet");
    EXPECT_THAT(after({"render", "--shading", ""}), shadings);
    EXPECT_THAT(after({"render", "--shading", "lo"}), ElementsAre("low-pass"));
    EXPECT_THAT(after({"render", "tetra", "--machine", "96"}), ElementsAre("964", "964dX"));
    EXPECT_THAT(after({"render", "--samples", ""}), IsEmpty()) << "a number is nobody's to guess";
    EXPECT_THAT(after({"study", ""}), ElementsAre("balance", "error", "stability", "shading"));
    EXPECT_THAT(after({"completion", ""}), ElementsAre("bash", "zsh", "fish"));
}

TEST_F(Completion, offers_them_behind_an_equals_sign_in_one_word_or_in_three) {
    EXPECT_THAT(after({"render", "--shading=lo"}), ElementsAre("--shading=low-pass"));
    EXPECT_THAT(after({"render", "--shading", "=", "lo"}), ElementsAre("low-pass"));
    EXPECT_THAT(after({"render", "--covers", "="}), Contains("area"));
}

TEST_F(Completion, goes_on_in_a_list_after_its_last_comma) {
    EXPECT_THAT(after({"render", "--aov", "Z,wo"}), ElementsAre("Z,word"));
    EXPECT_THAT(after({"render", "--aov=Z,N,al"}), ElementsAre("--aov=Z,N,alpha"));
}

TEST_F(Completion, offers_scenes_by_name_and_asks_for_their_files) {
    const std::vector<std::string> words = after({"render", ""});
    EXPECT_THAT(words, IsSupersetOf({"tetra", "menger", "animation/zoom"}));
    EXPECT_EQ(words.back(), ":files .pxm");
    EXPECT_THAT(after({"inspect", "tetra_h"}), ElementsAre("tetra_hierarchy", ":files .pxm"));
    EXPECT_THAT(after({"check", "tetra", "--werror", "meng"}), Contains("menger"));
    EXPECT_THAT(after({"study", "error", "meng"}), Contains("menger"));
    EXPECT_THAT(after({"render", "tetra", ""}), IsEmpty()) << "a render has one scene";
    EXPECT_THAT(after({"render", "--size", "8x8", "meng"}), Contains("menger"));
}

TEST_F(Completion, asks_for_files_and_folders) {
    EXPECT_THAT(after({"render", "tetra", "-o", ""}), ElementsAre(":files"));
    EXPECT_THAT(after({"render", "tetra", "--stats", ""}), ElementsAre(":files .json"));
    EXPECT_THAT(after({"render", "tetra", "--allow", ""}), ElementsAre(":folders"));
    EXPECT_THAT(after({"join", ""}), ElementsAre(":folders"));
    EXPECT_THAT(after({"compare", "a.exr", ""}), ElementsAre(":files .exr"));
}

TEST_F(Completion, offers_the_entries_of_a_file_that_is_imported) {
    const std::string fern = " { .5 0 0 .5 0 0 .5 .5 0 0 .5 1 0 .5 }\n";
    folder.write("two.ifs", "fern" + fern + "tree" + fern + "comment { ifs files }\n");
    folder.write("one.l", "koch { Angle 6\n Axiom F\n F=F+F--F+F\n}\n");
    EXPECT_THAT(after({"import", "two.ifs", "--entry", ""}), ElementsAre("fern", "tree"));
    EXPECT_THAT(after({"import", "one.l", "--entry", "k"}), ElementsAre("koch"));
    folder.write("a.flame",
                 "<flames><flame name=\"my leaf\"><xform weight=\"1\" linear=\"1\" "
                 "coefs=\".5 0 0 .5 0 0\"/></flame><flame/></flames>");
    folder.write("b.aifs", "@one\n$dim=2\nS=S|S\n@two\n$dim=2\nS=S|S\n");
    EXPECT_THAT(after({"import", "a.flame", "--entry", ""}), ElementsAre("my leaf", "flame 2"));
    EXPECT_THAT(after({"import", "b.aifs", "--entry", ""}), ElementsAre("one", "two"));
    folder.write("a.es", "box\n");
    for (const char* none : {"none.ifs", "none.flame", "a.es"})
        EXPECT_THAT(after({"import", none, "--entry", ""}), IsEmpty()) << none;
}

TEST_F(Completion, is_silent_about_what_it_does_not_know) {
    EXPECT_THAT(after({"redner", ""}), IsEmpty());
    EXPECT_THAT(after({"", "x"}), IsEmpty());
    EXPECT_THAT(after({"render", "--frob", ""}), Contains("tetra"));
    EXPECT_THAT(after({"models", "x"}), IsEmpty());
}

TEST_F(Completion, prints_a_script_for_each_shell) {
    for (const char* shell : {"bash", "zsh", "fish"}) {
        const Outcome told = run(folder, {"completion", shell});
        EXPECT_EQ(told.exit_code, 0);
        EXPECT_NE(told.out.find("completion words -- "), std::string::npos) << shell;
    }
}

}  // namespace
}  // namespace pxm::test
