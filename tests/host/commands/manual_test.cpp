// Laws of the manual and the help: every option, directive and exit code of the program stands in
// them, and nothing else does.
#include "host/commands/manual.hpp"

#include <fmt/format.h>
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

#include "host/commands/cmd.hpp"
#include "host/commands/help.hpp"
#include "host/process/exit_code.hpp"
#include "host/scene/parse/grammar.hpp"
#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

using Names = std::set<std::string>;

std::vector<host::CommandFacts> facts() {
    host::CommandLine line("pxm", "Ray traces.", "");
    const auto commands = host::add_commands(line);
    return line.facts();
}

std::string page_name(const host::CommandFacts& command) {
    return command.name.empty() ? "pxm" : "pxm-" + command.name;
}

fs::path text_file(const std::string& page) {
    return fs::path(source_dir) / "docs/man" / (page + ".scd");
}

std::string page_of(const host::CommandFacts& command) {
    return host::command_page(command, facts(), text_of(text_file(page_name(command))));
}

Names found(const std::string& text, const char* pattern) {
    const std::regex form(pattern, std::regex::multiline);
    Names names;
    for (std::sregex_iterator it(text.begin(), text.end(), form), end; it != end; ++it)
        names.insert((*it)[1]);
    return names;
}

/// The lines between a heading and the next one.
std::string section(const std::string& page, const std::string& heading) {
    const std::size_t start = page.find("# " + heading + "\n");
    if (start == std::string::npos) return "";
    const std::size_t end = page.find("\n# ", start + 1);
    return page.substr(start, end == std::string::npos ? end : end - start);
}

/// The options that stand at the beginnings of lines, and the values of arguments and options.
Names options_in(const std::string& page) {
    Names names;
    for (const std::string& line : found(section(page, "OPTIONS"), R"(^(\*-.*)$)"))
        for (const std::string& name : found(line, R"(\*(-[^*]+)\*)")) names.insert(name);
    return names;
}

Names options_of(const host::CommandFacts& command) {
    Names names;
    for (const host::OptionFacts& option : command.options)
        if (!option.is_argument) names.insert(option.names.begin(), option.names.end());
    return names;
}

TEST(Manual, there_is_a_text_for_every_command_and_for_nothing_else) {
    Names expected{"pxm-scene"};
    for (const host::CommandFacts& command : facts()) expected.insert(page_name(command));
    Names there;
    for (const auto& entry : fs::directory_iterator(fs::path(source_dir) / "docs/man"))
        there.insert(entry.path().stem().string());
    EXPECT_EQ(there, expected);
}

TEST(Manual, a_page_has_every_option_of_its_command_and_no_other) {
    for (const host::CommandFacts& command : facts()) {
        const std::string page = page_of(command);
        EXPECT_EQ(options_in(page), options_of(command)) << command.name;
        for (const host::OptionFacts& option : command.options)
            if (option.is_argument) {
                EXPECT_THAT(page, HasSubstr("_" + option.names[0] + "_\n\t"));
            }
    }
}

TEST(Manual, no_page_speaks_of_an_option_that_there_is_not) {
    Names known;
    for (const host::CommandFacts& command : facts()) known.merge(options_of(command));
    for (const char* page : {"pxm-scene", "pxm-render", "pxm"}) {
        for (const std::string& name : found(text_of(text_file(page)), R"((--[a-z0-9-]+))"))
            EXPECT_TRUE(known.contains(name)) << page << " " << name;
    }
    for (const host::CommandFacts& command : facts()) {
        for (const std::string& name : found(page_of(command), R"((--[a-z0-9-]+))"))
            EXPECT_TRUE(known.contains(name)) << command.name << " " << name;
    }
}

TEST(Manual, a_text_cannot_leave_its_page_without_a_heading) {
    for (const host::CommandFacts& command : facts()) {
        const std::string page = page_of(command);
        for (const char* heading :
             {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXAMPLES", "EXIT STATUS", "SEE ALSO"})
            EXPECT_FALSE(section(page, heading).empty()) << command.name << " " << heading;
    }
    EXPECT_THAT(section(page_of(facts()[0]), "COMMANDS"), HasSubstr("*pxm-render*(1)"));
}

TEST(Manual, the_page_of_scenes_has_every_block_and_directive_and_no_other) {
    const std::string page = host::scene_page(text_of(text_file("pxm-scene")));
    Names headings = found(page, R"(^# (.*)$)");
    for (const char* other : {"NAME", "DESCRIPTION", "TOP LEVEL", "FILES", "SEE ALSO"})
        EXPECT_EQ(headings.erase(other), 1U) << other;
    for (const host::BlockGrammar& block : host::all_blocks()) {
        std::string heading(block.kind);
        for (char& c : heading) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        EXPECT_EQ(headings.erase(heading), 1U) << heading;
        Names expected;
        for (const host::Directive& directive : block.directives) expected.emplace(directive.word);
        EXPECT_EQ(found(section(page, heading), R"(^\*([a-z0-9]+):?\*)"), expected) << heading;
    }
    EXPECT_THAT(headings, IsEmpty());
    EXPECT_EQ(found(section(page, "TOP LEVEL"), R"(^\*([a-z]+):?\*)"), (Names{"include", "let"}));
}

/// What the enumeration of exit codes and the signals that end a run say.
Names exit_codes() {
    Names codes;
    for (int code = 0; code <= static_cast<int>(host::ExitCode::parts_missing); ++code)
        codes.insert(std::to_string(code));
    for (const char* ended : {"129", "130", "143", "152"}) codes.insert(ended);
    return codes;
}

TEST(Manual, exit_codes_are_those_of_the_program_in_pages_help_and_document) {
    const Folder folder;
    for (const host::CommandFacts& command : facts()) {
        EXPECT_EQ(found(section(page_of(command), "EXIT STATUS"), R"(^\*(\d+)\*$)"), exit_codes());
        const Arguments asked =
            command.name.empty() ? Arguments{"--help"} : Arguments{command.name, "--help"};
        const std::string help = run(folder, asked).out;
        EXPECT_EQ(found(help.substr(help.find("Exit codes:")), R"(^  (\d+) )"), exit_codes());
    }
    const std::string document = text_of(fs::path(source_dir) / "docs/command-line.md");
    const std::string table = document.substr(document.find("## Exit codes"));
    Names documented;
    for (const std::string& cell : found(table, R"(^\| ([\d, ]+) \|)"))
        documented.merge(found(cell, R"((\d+))"));
    EXPECT_EQ(documented, exit_codes());
}

TEST(Help, leads_with_two_examples_and_ends_with_where_to_read_on) {
    const Folder folder;
    for (const host::CommandFacts& command : facts()) {
        const Arguments asked =
            command.name.empty() ? Arguments{"--help"} : Arguments{command.name, "--help"};
        const Outcome told = run(folder, asked);
        EXPECT_EQ(told.exit_code, 0);
        const auto examples = host::examples_of(command.name);
        ASSERT_EQ(examples.size(), 2U) << command.name;
        std::istringstream lines(told.out);
        for (const host::Example& example : examples) {
            std::string line;
            std::getline(lines, line);
            EXPECT_THAT(line, StartsWith(std::string(example.line)));
        }
        EXPECT_THAT(told.out, HasSubstr("\nUsage: pxm"));
        EXPECT_THAT(told.out, testing::EndsWith(fmt::format(
                                  "\nRead on: man {}, man 5 pxm-scene; docs/command-line.md\n",
                                  page_name(command))));
    }
}

TEST(Help, its_examples_are_command_lines_that_pxm_takes) {
    for (const host::CommandFacts& command : facts()) {
        for (const host::Example& example : host::examples_of(command.name)) {
            const std::string text(example.line.substr(0, example.line.find(" >")));
            std::istringstream words(text);
            std::vector<std::string> arguments;
            for (std::string word; words >> word;) arguments.push_back(word);
            std::vector<const char*> argv;
            for (const std::string& word : arguments) argv.push_back(word.c_str());
            host::CommandLine line("pxm", "", "");
            const auto commands = host::add_commands(line);
            EXPECT_NO_THROW((void)line.read(static_cast<int>(argv.size()), argv.data())) << text;
            if (!command.name.empty()) {
                EXPECT_EQ(arguments[1], command.name);
            }
        }
    }
}

TEST(Help, says_of_every_value_what_it_may_be) {
    for (const host::CommandFacts& command : facts()) {
        for (const host::OptionFacts& option : command.options)
            EXPECT_NE(option.value, "TEXT") << command.name << " " << option.names.back()
                                            << ": add it to host/commands/option_values.cpp";
    }
}

TEST(Help, every_kind_of_value_is_one_of_an_option_that_there_is) {
    const auto commands = facts();
    for (const host::ValueName& name : host::value_names()) {
        bool used = false;
        for (const host::CommandFacts& command : commands)
            for (const host::OptionFacts& option : command.options)
                used |= option.value == name.value &&
                        (name.command.empty() || name.command == command.name) &&
                        std::ranges::find(option.names, name.option) != option.names.end();
        EXPECT_TRUE(used) << name.command << " " << name.option;
    }
}

TEST(Help, keeps_the_hidden_command_to_itself) {
    const Folder folder;
    const Outcome told = run(folder, {"--help"});
    EXPECT_THAT(told.out, Not(HasSubstr("manual")));
    const Outcome refused = run(folder, {"nothing"});
    EXPECT_THAT(refused.err, Not(HasSubstr("manual")));
}

TEST(Suggestions, the_nearest_command_option_and_value_are_named) {
    const Folder folder;
    folder.write("tetra.pxm", tetra_scene);
    const auto refused = [&](const Arguments& arguments, const std::string& part) {
        expect_refusal_naming(folder, arguments, 2, {part});
    };
    refused({"redner", "tetra.pxm"},
            "compare study models asm studio completion (did you mean 'render'?)");
    refused({"render", "tetra.pxm", "--smaples", "4"}, "--smaples (did you mean '--samples'?)");
    refused({"render", "tetra.pxm", "--smaples=4"}, "--smaples=4 (did you mean '--samples'?)");
    refused({"check", "tetra.pxm", "--samples", "4"}, "not expected: --samples\n");
    refused({"render", "tetra.pxm", "--shading", "lowpass"},
            "constant, low-pass, high-pass, facet (did you mean 'low-pass'?)");
    refused({"render", "tetra.pxm", "-o", "a.exr", "--aov", "Z,wrod"}, "(did you mean 'word'?)");
    refused({"render", "tetra.pxm", "--machine", "964dx"}, "(did you mean '964dX'?)");
    refused({"study", "balanec", "-o", "report"}, "(did you mean 'balance'?)");
    refused({"completion", "bsh"}, "expected one of bash, zsh, fish (did you mean 'bash'?)");
}

}  // namespace
}  // namespace pxm::test
