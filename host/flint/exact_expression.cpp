#include "host/flint/exact_expression.hpp"

namespace pxm::host {

namespace {

using exact::Algebraic;
using exact::NotExact;
using exact::Polynomial;

constexpr int deepest_let = 100;

/// Longer numbers cost more than anybody's scene is worth.
constexpr std::size_t longest_number = 60;
constexpr double largest_number = 1e100;

}  // namespace

ExactExpressions::ExactExpressions(const Scene& scene) {
    for (std::size_t f = 0; f < scene.files.size(); ++f) {
        const std::string_view text = scene.files[f].text;
        Lexer lexer(text, static_cast<int>(f));
        int depth = 0;
        for (Token token = lexer.next(); token.kind != TokenKind::end;) {
            if (token.is('{')) ++depth;
            if (token.is('}')) --depth;
            if (depth != 0 || !token.is_word("let")) {
                token = lexer.next();
                continue;
            }
            const Token name = lexer.next();
            const Token equals = lexer.next();
            if (!equals.is('=')) break;
            const auto from = static_cast<std::size_t>(equals.text.data() - text.data()) + 1;
            lets_.emplace(std::string(name.text), Let{static_cast<int>(f), text.substr(from)});
            token = lexer.next();
        }
    }
}

Algebraic ExactExpressions::read(TokenReader& tokens) {
    Algebraic value = product(tokens);
    while (tokens.peek().is('+') || tokens.peek().is('-')) {
        const bool plus = tokens.take().is('+');
        const Algebraic other = product(tokens);
        value = plus ? field_.add(value, other) : field_.subtract(value, other);
    }
    return value;
}

Algebraic ExactExpressions::product(TokenReader& tokens) {
    const auto signed_operand = [&] {
        bool negative = false;
        while (tokens.peek().is('-') || tokens.peek().is('+'))
            if (tokens.take().is('-')) negative = !negative;
        const Algebraic value = operand(tokens);
        return negative ? field_.subtract(exact::whole(0), value) : value;
    };
    Algebraic value = signed_operand();
    while (tokens.peek().is('*') || tokens.peek().is('/')) {
        const bool times = tokens.take().is('*');
        const Algebraic other = signed_operand();
        if (!times && other.value.is_zero()) throw NotExact{"a division by what is exactly 0"};
        value = times ? field_.multiply(value, other) : field_.divide(value, other);
    }
    return value;
}

Algebraic ExactExpressions::operand(TokenReader& tokens) {
    const Token token = tokens.take();
    if (token.is('(')) {
        const Algebraic value = read(tokens);
        tokens.expect(')');
        return value;
    }
    if (token.kind == TokenKind::number) {
        const auto value = number_value(token.text);
        const bool sane = value && *value < largest_number &&
                          (*value == 0 || *value > 1 / largest_number) &&
                          token.text.size() <= longest_number;
        if (!sane) throw NotExact{"a number of too many digits"};
        const std::string_view digits = token.text.substr(0, token.text.find_first_of("eE"));
        if (*value == 0 && digits.find_first_not_of("0.") != std::string_view::npos)
            throw NotExact{"a number of too many digits"};
        if (*value == 0) return exact::whole(0);
        return {0, Polynomial::decimal(std::string(token.text))};
    }
    return named(tokens, token);
}

Algebraic ExactExpressions::named(TokenReader& tokens, const Token& word) {
    if (word.text == "pi") throw NotExact{"pi is in no number field"};
    if (word.text == "phi")
        return field_.divide(field_.add(exact::whole(1), field_.square_root(exact::whole(5))),
                             exact::whole(2));
    const bool function =
        word.text == "sqrt" || word.text == "sin" || word.text == "cos" || word.text == "tan";
    if (!function) return constant(std::string(word.text));
    tokens.expect('(');
    const Algebraic argument = read(tokens);
    tokens.expect(')');
    if (word.text == "sqrt") return field_.square_root(argument);
    if (word.text == "sin") return field_.sine(argument);
    if (word.text == "cos") return field_.cosine(argument);
    const Algebraic cosine = field_.cosine(argument);
    if (cosine.value.is_zero()) throw NotExact{"a tangent that is infinite"};
    return field_.divide(field_.sine(argument), cosine);
}

Algebraic ExactExpressions::constant(const std::string& name) {
    const auto known = known_.find(name);
    if (known != known_.end()) return known->second;
    const auto let = lets_.find(name);
    if (let == lets_.end()) throw NotExact{"'" + name + "' changes with time"};
    if (++depth_ > deepest_let) throw NotExact{"'let's nested too deeply"};
    Diagnostics unused;
    TokenReader tokens(let->second.text, let->second.file, unused);
    const Algebraic value = read(tokens);
    --depth_;
    known_.emplace(name, value);
    return value;
}

}  // namespace pxm::host
