#include "host/import/fractint/fractint_l.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pxm::host {
namespace {

std::string complaints(const std::string& text) {
    Diagnostics diagnostics;
    for (FractintL& l : parse_fractint_l(text, diagnostics)) {
        if (!l.entry.diagnostics.has_errors()) (void)lsystem_of(l);
        diagnostics.append(l.entry.diagnostics);
    }
    return diagnostics.text({{"f.l", text}});
}

FractintL only(const std::string& text) {
    EXPECT_EQ(complaints(text), "");
    Diagnostics diagnostics;
    auto list = parse_fractint_l(text, diagnostics);
    EXPECT_EQ(list.size(), 1U);
    return list.at(0);
}

std::vector<TurtleCommand> axiom(const std::string& word) {
    FractintL l = only("t { Angle 8\nAxiom " + word + "\n}");
    return lsystem_of(l).axiom;
}

TEST(FractintL, statements_are_read_however_they_are_spaced) {
    for (const char* text :
         {"t {\n Angle 6\n Axiom F--F\n F=F+F\n X=\n}",
          "t{Angle=6;six\r\nAXIOM=f--F\r\nF = F + F\n x=}", "t { angle 6 axiom F--F F=F+F X= }",
          "comment { F=F }\nt {\nX=\nF=F\nf=+F\nAxiom F - -F\nangle 6 }"}) {
        const FractintL l = only(text);
        EXPECT_EQ(l.angle, 6) << text;
        EXPECT_EQ(l.axiom->text, "f--f") << text;
        ASSERT_EQ(l.rules.size(), 2U) << text;
        EXPECT_EQ(l.rules.at('f').text, "f+f") << text;
        EXPECT_EQ(l.rules.at('x').text, "") << text;
    }
}

TEST(FractintL, an_entry_may_lack_its_name_and_its_braces) {
    for (const char* text :
         {"Angle 6\nAxiom F--F\nF=F+F\n", "; a comment\naxiom F--F angle 6 F=F+F",
          "{ Angle 6\nAxiom F--F\nF=F+F }", "Angle=6 Axiom \"F--F\"\nF=\"F+F\""}) {
        const FractintL l = only(text);
        EXPECT_EQ(l.entry.name, "");
        EXPECT_EQ(l.angle, 6) << text;
        EXPECT_EQ(l.axiom->text, "f--f") << text;
        EXPECT_EQ(l.rules.at('f').text, "f+f") << text;
        EXPECT_EQ(l.entry.has_quotes, std::string(text).find('"') != std::string::npos);
    }
    const FractintL quoted = only("\"a\" { Angle 6\nAxiom F }");
    EXPECT_EQ(quoted.entry.name, "a");
    EXPECT_TRUE(quoted.entry.has_quotes);
    Diagnostics diagnostics;
    EXPECT_EQ(parse_fractint_l("{ no entry: Axiom F }\nt { Axiom F }", diagnostics).size(), 1U);
    EXPECT_EQ(parse_fractint_l("Axiom F F=FF\nt { Axiom F }", diagnostics).size(), 2U);
    EXPECT_FALSE(diagnostics.has_errors());
}

TEST(FractintL, commands_move_the_turtle_as_documented) {
    const auto turn = [](const std::string& word, TurtleOp op) {
        const TurtleCommand command = axiom(word + "F").at(0);
        EXPECT_EQ(command.op, op) << word;
        return command.value;
    };
    EXPECT_EQ(turn("+", TurtleOp::turn), 1);
    EXPECT_EQ(turn("-", TurtleOp::turn), -1);
    EXPECT_EQ(turn("\\30", TurtleOp::turn_degrees), 30);
    EXPECT_EQ(turn("/7.5", TurtleOp::turn_degrees), -7.5);
    EXPECT_EQ(turn("|", TurtleOp::round), 4);
    EXPECT_EQ(axiom("c12<3>4F").size(), 1U);
}

TEST(FractintL, factors_of_a_step_are_kept_as_they_are_written) {
    const auto factor = [](const std::string& word) {
        const TurtleCommand command = axiom(word + "F").at(0);
        EXPECT_EQ(command.op, TurtleOp::step) << word;
        return std::string(command.factor.inverse ? "i" : "") + (command.factor.root ? "q" : "") +
               command.factor.decimal;
    };
    EXPECT_EQ(factor("@.5"), ".5");
    EXPECT_EQ(factor("@I4"), "i4");
    EXPECT_EQ(factor("@Q4"), "q4");
    EXPECT_EQ(factor("@IQ4"), "iq4");
    EXPECT_EQ(factor("@QI4"), "iq4");
}

TEST(FractintL, round_of_an_odd_angle_is_the_largest_turn_below_180) {
    FractintL l = only("t { angle 5 axiom |F }");
    EXPECT_EQ(lsystem_of(l).axiom.at(0).value, -2);
}

TEST(FractintL, a_block_without_a_name_is_a_comment) {
    EXPECT_EQ(only("{ by hand: a=b }\nt { axiom F }\n{ more }").entry.name, "t");
}

TEST(FractintL, mistakes_are_told_with_their_place) {
    EXPECT_EQ(complaints("t { Angle 4\n Axiom F[+F\n}"),
              "f.l:2:9: error: '[' without its ']'\n    Axiom F[+F\n           ^");
    EXPECT_EQ(complaints("t { Angle 4\n Axiom F]\n}"),
              "f.l:2:9: error: ']' without its '['\n    Axiom F]\n           ^");
    EXPECT_EQ(
        complaints("t { Angle 0\n Axiom F\n}"),
        "f.l:1:11: error: 'Angle' takes a number n of 1 or more (turns are 360/n degrees), not "
        "'0'\n    t { Angle 0\n              ^");
    EXPECT_EQ(complaints("t { Axiom F+F }"),
              "f.l:1:12: error: a turn, but the entry has no 'Angle'\n    t { Axiom F+F }\n"
              "               ^");
    EXPECT_EQ(complaints("t { Angle 4 }"),
              "f.l:1:1: error: entry \"t\" has no 'Axiom'\n    t { Angle 4 }\n    ^");
    EXPECT_EQ(complaints("t { Axiom F F<G=FG }"),
              "f.l:1:13: error: 'F<G' is replaced only in a context: rules X=string alone have an "
              "exact system\n    t { Axiom F F<G=FG }\n                ^");
    EXPECT_EQ(complaints("t { Axiom F +=F }"),
              "f.l:1:13: error: '+' moves the turtle: a rule cannot replace it\n"
              "    t { Axiom F +=F }\n                ^");
    EXPECT_EQ(complaints("t { Axiom F@0F }"),
              "f.l:1:12: error: the factor of the step must be greater than 0\n"
              "    t { Axiom F@0F }\n               ^");
    EXPECT_EQ(complaints("t { Axiom F\nF=FF"),
              "f.l:1:1: error: entry \"t\" has no closing '}'\n    t { Axiom F\n    ^");
    EXPECT_EQ(complaints("t { Axiom F\nhello\n}"),
              "f.l:2:1: error: expected 'Angle', 'Axiom', a rule X=string or '}', found 'hello'\n"
              "    hello\n    ^");
    EXPECT_THAT(complaints("t { Angle 5\nAxiom F|F!F\n}"), testing::HasSubstr("is not mirrored"));
    EXPECT_THAT(complaints("t { Axiom F/F }"), testing::HasSubstr("'/' needs a number: degrees"));
}

}  // namespace
}  // namespace pxm::host
