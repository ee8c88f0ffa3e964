#include "host/scene/parse/expression.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/scene/parse/grammar.hpp"
#include "host/scene/parse/keys.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr int nesting_limit =
    200;  // parentheses; the recursion below is no deeper than four times this

/// Sine in degrees, exact at quarter turns: cos 90 is zero, as in host/math/affine.
double sine(double degrees) {
    const double turned = std::remainder(degrees, 360.0);
    const double value = std::sin(turned * std::numbers::pi / 180.0);
    return std::remainder(turned, 90.0) == 0.0 ? std::round(value) : value;
}

double cosine(double degrees) {
    const double turned = std::remainder(degrees, 360.0);
    const double value = std::cos(turned * std::numbers::pi / 180.0);
    return std::remainder(turned, 90.0) == 0.0 ? std::round(value) : value;
}

double tangent(double degrees) { return sine(degrees) / cosine(degrees); }

struct Function {
    std::string_view word;
    double (*compute)(double);
};
constexpr std::array<Function, 4> functions{{
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"sin", sine},
    {"cos", cosine},
    {"tan", tangent},
}};

class ExpressionParser {
  public:
    ExpressionParser(TokenReader& tokens, const Constants& constants, Behind behind)
        : tokens_(tokens), constants_(constants), behind_(behind) {}

    double sum() {
        double value = product();
        while (tokens_.peek().is('+') || tokens_.peek().is('-')) {
            const Token sign = tokens_.take();
            const double operand = product();
            value = finite(sign.is('+') ? value + operand : value - operand, sign);
        }
        return value;
    }

  private:
    double product() {
        double value = signed_operand();
        while (tokens_.peek().is('*') || tokens_.peek().is('/')) {
            const Token sign = tokens_.take();
            const double operand = signed_operand();
            if (sign.is('/') && operand == 0.0) tokens_.fail(sign.position, "division by zero");
            value = finite(sign.is('*') ? value * operand : value / operand, sign);
        }
        return value;
    }

    /// Signs are a loop, not a recursion: a file of nothing but '-' must not exhaust the stack.
    double signed_operand() {
        bool negative = false;
        while (tokens_.peek().is('-') || tokens_.peek().is('+'))
            if (tokens_.take().is('-')) negative = !negative;
        const double value = operand();
        return negative ? -value : value;
    }

    double operand() {
        const Token token = tokens_.peek();
        if (token.is('(')) return parenthesised();
        if (token.kind == TokenKind::number) {
            const std::optional<double> value = number_value(tokens_.take().text);
            if (!value) tokens_.fail(token.position, "this number is too large");
            return *value;
        }
        const bool keyword = is_keyword(token.text) && !is_number_word(token.text);
        const bool directive = behind_ != Behind::colon && tokens_.peek_second().is(':');
        if (token.kind != TokenKind::word || keyword || directive)
            tokens_.fail_expected("a number");
        return named(tokens_.take());
    }

    double parenthesised() {
        const Token open = tokens_.expect('(');
        if (++depth_ > nesting_limit)
            tokens_.fail(open.position,
                         fmt::format("parentheses nested deeper than {}", nesting_limit));
        const double value = sum();
        tokens_.expect(')');
        --depth_;
        return value;
    }

    double named(const Token& word) {
        if (word.text == "pi") return std::numbers::pi;
        if (word.text == "phi") return std::numbers::phi;
        for (const Function& function : functions) {
            if (word.text != function.word) continue;
            const double argument = parenthesised();
            return finite(function.compute(argument), word);
        }
        const auto constant = constants_.find(std::string(word.text));
        if (constant == constants_.end()) {
            if (word.text == "key" && tokens_.peek().is('(')) return key(word);
            const bool of_time = word.text == "t" || word.text == "frame";
            tokens_.fail(word.position,
                         fmt::format("expected a number, found '{}', {}", printable(word.text),
                                     of_time ? "which is known after an 'animation' only"
                                             : "which no 'let' has named"));
        }
        return constant->second;
    }

    double key(const Token& word) {
        if (++depth_ > nesting_limit)
            tokens_.fail(word.position,
                         fmt::format("parentheses nested deeper than {}", nesting_limit));
        const auto sum_before = [&](Behind behind) {
            const Behind outer = std::exchange(behind_, behind);
            const double value = sum();
            behind_ = outer;
            return value;
        };
        const auto value = read_keys<1>(
            tokens_, Interpolation::smooth,
            [&] { return std::array{sum_before(Behind::anything)}; }, sum_before);
        --depth_;
        return finite(value[0], word);
    }

    double finite(double value, const Token& at) {
        if (!std::isfinite(value))
            tokens_.fail(at.position, fmt::format("'{}' has no finite value here", at.text));
        return value;
    }

    TokenReader& tokens_;
    const Constants& constants_;
    Behind behind_;
    int depth_ = 0;
};

}  // namespace

double parse_expression(TokenReader& tokens, const Constants& constants, Behind behind) {
    return ExpressionParser(tokens, constants, behind).sum();
}

}  // namespace pxm::host
