// Laws of host/scene/parse/expression and of the numbers of host/scene/parse/lexer.
#include "host/scene/parse/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pxm::host {
namespace {

struct Outcome {
    double value = 0;
    std::string message;
};

Outcome evaluate(const std::string& text) {
    Diagnostics diagnostics;
    TokenReader tokens(text, 0, diagnostics);
    const Constants constants{{"half", 0.5}, {"x", 3.0}};
    Outcome outcome;
    try {
        outcome.value = parse_expression(tokens, constants);
        EXPECT_EQ(tokens.peek().kind, TokenKind::end) << text;
    } catch (const SyntaxError&) {
        outcome.message = diagnostics.text({{"e", text}});
        outcome.message = outcome.message.substr(0, outcome.message.find('\n'));
    }
    return outcome;
}

double value(const std::string& text) {
    const Outcome outcome = evaluate(text);
    EXPECT_EQ(outcome.message, "") << text;
    return outcome.value;
}

TEST(Expression, operators_bind_as_in_arithmetic) {
    EXPECT_EQ(value("1+2*3"), 7);
    EXPECT_EQ(value("(1+2)*3"), 9);
    EXPECT_EQ(value("8/4/2"), 1);
    EXPECT_EQ(value("8-4-2"), 2);
    EXPECT_EQ(value("-2*-3"), 6);
    EXPECT_EQ(value("1--2"), 3);
    EXPECT_EQ(value("-(1+half)*x"), -4.5);
    EXPECT_EQ(value("1/3"), 1.0 / 3);
}

TEST(Expression, functions_take_degrees_and_are_exact_at_quarter_turns) {
    EXPECT_EQ(value("sqrt(3)/3"), std::sqrt(3.0) / 3);
    EXPECT_EQ(value("cos(90)"), 0);
    EXPECT_EQ(value("sin(-450)"), -1);
    EXPECT_EQ(value("tan(180)"), 0);
    EXPECT_NEAR(value("-2*cos(72)"), 1 - std::numbers::phi, 1e-15);
    EXPECT_NEAR(value("tan(45)"), 1, 1e-15);
    EXPECT_EQ(value("pi"), std::numbers::pi);
    EXPECT_EQ(value("phi*phi"), std::numbers::phi * std::numbers::phi);
}

TEST(Expression, every_form_of_a_number_is_read_to_the_nearest_double) {
    EXPECT_EQ(value("5."), 5);
    EXPECT_EQ(value(".5"), 0.5);
    EXPECT_EQ(value("1e-3"), 1e-3);
    EXPECT_EQ(value("1.5E+2"), 150);
    EXPECT_EQ(value("0.1"), 0.1);
    EXPECT_EQ(value("1e-999"), 0);
    EXPECT_EQ(value("0." + std::string(400, '0') + "1e401"), 1);
    EXPECT_EQ(value("0e999999999999999999999"), 0);
}

TEST(Expression, a_value_that_is_no_number_is_an_error_at_its_operator) {
    EXPECT_EQ(evaluate("1/(2-2)").message, "e:1:2: error: division by zero");
    EXPECT_EQ(evaluate("sqrt(-1)").message, "e:1:1: error: 'sqrt' has no finite value here");
    EXPECT_EQ(evaluate("tan(90)").message, "e:1:1: error: 'tan' has no finite value here");
    EXPECT_EQ(evaluate("1e308*10").message, "e:1:6: error: '*' has no finite value here");
    EXPECT_EQ(evaluate("1 + 1e999").message, "e:1:5: error: this number is too large");
    EXPECT_EQ(evaluate("1" + std::string(400, '0') + "e-2").message,
              "e:1:1: error: this number is too large");
}

TEST(Expression, what_is_missing_is_named) {
    EXPECT_EQ(evaluate("").message, "e:1:1: error: expected a number, found the end of the file");
    EXPECT_EQ(evaluate("1+").message, "e:1:3: error: expected a number, found the end of the file");
    EXPECT_EQ(evaluate("(1").message, "e:1:3: error: expected ')', found the end of the file");
    EXPECT_EQ(evaluate("sin 5").message, "e:1:5: error: expected '(', found '5'");
    EXPECT_EQ(evaluate("third").message,
              "e:1:1: error: expected a number, found 'third', which no 'let' has named");
    EXPECT_EQ(evaluate("newmap").message, "e:1:1: error: expected a number, found 'newmap'");
    EXPECT_EQ(evaluate("\x93").message, "e:1:1: error: expected a number, found byte 0x93");
}

TEST(Expression, nesting_has_a_limit_and_signs_have_none) {
    EXPECT_EQ(value(std::string(200, '(') + "1" + std::string(200, ')')), 1);
    EXPECT_EQ(evaluate(std::string(201, '(') + "1" + std::string(201, ')')).message,
              "e:1:201: error: parentheses nested deeper than 200");
    EXPECT_EQ(value(std::string(1'000'001, '-') + "1"), -1);
}

}  // namespace
}  // namespace pxm::host
