// Laws of numbers on the command line: decimal, whole, in range, of every option there is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <functional>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/text/number_text.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

/// Whether the option, given that text alone, takes it.
bool takes(CLI::Option& option, const std::string& text) {
    option.clear();
    option.add_result(text);
    try {
        option.run_callback();
        return true;
    } catch (const CLI::ParseError&) {
        return false;
    }
}

/// Calls `law` with every option of every command that takes some number and refuses a word, and
/// with a number that it takes; if it can be, one that octal digits cannot spell.
int for_every_number_option(
    const std::function<void(CLI::Option& option, const std::string& taken)>& law) {
    host::CommandLine line("pxm", "", "");
    const auto commands = host::add_commands(line);
    int found = 0;
    for (const host::AddedCommand& added : commands) {
        CLI::App& command = added.command.app();
        for (CLI::Option* option : command.get_options()) {
            if (option->get_expected_max() == 0 || takes(*option, "eight")) continue;
            const char* taken = nullptr;
            for (const char* number : {"8", "9", "0.8", "108", "1", "0"}) {
                if (taken == nullptr && takes(*option, number)) taken = number;
            }
            if (taken == nullptr) continue;
            ++found;
            SCOPED_TRACE(fmt::format("{} {} {}", command.get_name(), option->get_name(), taken));
            law(*option, taken);
        }
    }
    return found;
}

TEST(NumberOptions, leading_zeros_change_nothing) {
    const int found = for_every_number_option([](CLI::Option& option, const std::string& taken) {
        EXPECT_TRUE(takes(option, "0" + taken));
        EXPECT_TRUE(takes(option, "000" + taken));
        EXPECT_TRUE(takes(option, "+" + taken));
        // CLI11 would convert what is left of the text: it must be what was written, less the
        // zeros.
        EXPECT_TRUE(takes(option, "0" + taken));
        option.clear();
        option.add_result("0" + taken);
        option.run_callback();
        EXPECT_EQ(option.reduced_results().at(0), taken);
    });
    EXPECT_GE(found, 16);
}

TEST(NumberOptions, nothing_but_decimal_digits_is_a_number) {
    for_every_number_option([](CLI::Option& option, const std::string& taken) {
        for (const std::string& text :
             {"0x" + taken, "0b" + taken, "0o" + taken, " " + taken, taken + " ", "\t" + taken,
              taken + "x", taken + "k", taken + ",0", "++" + taken, "+-" + taken, "'" + taken,
              std::string("nan"), std::string("inf"), std::string("+"), std::string("-"),
              std::string(".")}) {
            EXPECT_FALSE(takes(option, text)) << '"' << text << '"';
        }
    });
}

TEST(NumberOptions, a_whole_number_has_no_exponent_and_no_overflow) {
    CLI::App app;
    std::uint64_t value = 0;
    host::CommandOptions(app).add_option("--n", value, "").transform(host::any_whole_number());
    CLI::Option* option = app.get_option("--n");
    for (const char* text : {"1e3", "1.0", "-1", "18446744073709551616", "99999999999999999999",
                             "340282366920938463463374607431768211457"}) {
        EXPECT_FALSE(takes(*option, text)) << text;
    }
    EXPECT_TRUE(takes(*option, "0018446744073709551615"));
    EXPECT_EQ(value, 18446744073709551615U);
    EXPECT_TRUE(takes(*option, "010"));
    EXPECT_EQ(value, 10U);
}

TEST(NumberOptions, a_text_is_read_whole_or_not_at_all) {
    EXPECT_EQ(host::number_of_text<long>("-010"), -10);
    EXPECT_EQ(host::number_of_text<long>("+08"), 8);
    EXPECT_EQ(host::number_of_text<double>("007.50"), 7.5);
    EXPECT_EQ(host::number_of_text<double>("1e3"), 1000);
    EXPECT_EQ(host::number_of_text<double>("0x10"), std::nullopt);
    EXPECT_EQ(host::number_of_text<double>("1e999"), std::nullopt);
    EXPECT_EQ(host::number_of_text<int>("2147483648"), std::nullopt);
    EXPECT_EQ(host::number_of_text<int>(""), std::nullopt);
}

class Numbers : public testing::Test {
  protected:
    Numbers() { folder.write("tetra.pxm", tetra_scene); }
    Folder folder;
};

TEST_F(Numbers, a_seed_with_a_leading_zero_is_the_decimal_seed) {
    for (const char* seed : {"8", "08", "10", "010"}) {
        expect_done(folder, {"points", "tetra.pxm", "-n", "0050", "--quiet", "--seed", seed, "-o",
                             std::string(seed) + ".ply"});
    }
    EXPECT_EQ(text_of(folder.path("8.ply")), text_of(folder.path("08.ply")));
    EXPECT_EQ(text_of(folder.path("10.ply")), text_of(folder.path("010.ply")));
    EXPECT_NE(text_of(folder.path("8.ply")), text_of(folder.path("10.ply")));
}

TEST_F(Numbers, what_is_no_number_in_range_is_named_with_what_is_expected) {
    const std::string usage = "\ntry: pxm --help, or pxm COMMAND --help";
    for (const char* text : {"1e3", " 5", "5x", "99999999999999999999", "0", "0x10", "-1", "1025"})
        expect_refusal(folder, {"render", "tetra.pxm", "--threads", text}, 2,
                       fmt::format("--threads: found \"{}\", expected a whole number from 1 to "
                                   "1024{}",
                                   text, usage));
    expect_refusal(folder, {"points", "tetra.pxm", "-o", "a.ply", "-n", "0"}, 2,
                   "--count: found \"0\", expected a whole number from 1 to 1000000000000" + usage);
    expect_refusal(folder, {"compare", "a.exr", "b.exr", "--tolerance", "5%"}, 2,
                   "--tolerance: found \"5%\", expected a number from 0 to 1" + usage);
}

TEST_F(Numbers, texts_of_several_numbers_follow_the_same_rule) {
    const auto refused = [&](const char* option, const char* text) {
        expect_refusal_naming(folder, {"render", "tetra.pxm", option, text}, 2,
                              {std::string(option) + ": found \"" + text + "\", expected "});
    };
    for (const char* text : {"0x8x8", "8 x8", "8x8 ", "1e1x8", "99999999999999999999x8"})
        refused("--size", text);
    for (const char* text : {"0x0,0,8,8", "0,0, 8,8", "0,0,8,8,"}) refused("--crop", text);
    refused("--pixel", "1,0x1");
    refused("--covers", "0x1,0x2");
    const Outcome told =
        run(folder, {"render", "tetra.pxm", "--size", "010x+08", "--pixel", "09,007"});
    EXPECT_EQ(told.exit_code, 0) << told.err;
    EXPECT_EQ(told.out,
              run(folder, {"render", "tetra.pxm", "--size", "10x8", "--pixel", "9,7"}).out);
}

TEST_F(Numbers, maps_of_a_point_are_decimal) {
    const Outcome told = run(folder, {"inspect", "tetra.pxm", "--point", "04,1"});
    EXPECT_EQ(told.exit_code, 0) << told.err;
    EXPECT_EQ(told.out, run(folder, {"inspect", "tetra.pxm", "--point", "4,1"}).out);
    expect_refusal(folder, {"inspect", "tetra.pxm", "--point", "5"}, 2,
                   "--point: ifs \"tetra\" has no map \"5\"");
}

TEST_F(Numbers, a_scene_reads_decimal_numbers_too) {
    folder.write("zeros.pxm",
                 "ifs a { newmap scale: 00.50 newmap scale: 0.50 translate: 010,08,0"
                 " start: 02, 1 }\n");
    folder.write("plain.pxm",
                 "ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 10,8,0"
                 " start: 2, 1 }\n");
    const Outcome zeros = run(folder, {"inspect", "zeros.pxm", "--point", "2"});
    EXPECT_EQ(zeros.exit_code, 0) << zeros.err;
    EXPECT_EQ(zeros.out, run(folder, {"inspect", "plain.pxm", "--point", "2"}).out);
    folder.write("hex.pxm", "ifs a { newmap scale: 0.5 translate: 0x10,0,0 }\n");
    expect_refusal_naming(folder, {"inspect", "hex.pxm"}, 3, {"hex.pxm:1:39: error: "});
}

TEST_F(Numbers, entries_of_fractint_are_decimal) {
    const std::string rules = "\n Axiom F\n F=F+F--F+F\n}\n";
    folder.write("zeros.l", "koch { Angle 06" + rules);
    folder.write("plain.l", "koch { Angle 6" + rules);
    const Outcome zeros = run(folder, {"import", "zeros.l", "-o", "-"});
    EXPECT_EQ(zeros.exit_code, 0) << zeros.err;
    const Outcome plain = run(folder, {"import", "plain.l", "-o", "-"});
    // The first line names the file.
    EXPECT_EQ(zeros.out.substr(zeros.out.find('\n')), plain.out.substr(plain.out.find('\n')));
}

}  // namespace
}  // namespace pxm::test
