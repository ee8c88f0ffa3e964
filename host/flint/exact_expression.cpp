#include "host/flint/exact_expression.hpp"

namespace pxm::host {

namespace {

using exact::NotExact;

constexpr int deepest_let = 100;

/// Longer numbers cost more than anybody's scene is worth.
constexpr std::size_t longest_number = 60;
constexpr double largest_number = 1e100;

}  // namespace

template <class Numbers>
ExactExpressions<Numbers>::ExactExpressions(const Scene& scene) {
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

template <class Numbers>
auto ExactExpressions<Numbers>::read(TokenReader& tokens) -> Value {
    Value value = product(tokens);
    while (tokens.peek().is('+') || tokens.peek().is('-')) {
        const bool plus = tokens.take().is('+');
        const Value other = product(tokens);
        value = plus ? numbers_.add(value, other) : numbers_.subtract(value, other);
    }
    return value;
}

template <class Numbers>
auto ExactExpressions<Numbers>::product(TokenReader& tokens) -> Value {
    const auto signed_operand = [&] {
        bool negative = false;
        while (tokens.peek().is('-') || tokens.peek().is('+'))
            if (tokens.take().is('-')) negative = !negative;
        const Value value = operand(tokens);
        return negative ? numbers_.subtract(numbers_.whole(0), value) : value;
    };
    Value value = signed_operand();
    while (tokens.peek().is('*') || tokens.peek().is('/')) {
        const bool times = tokens.take().is('*');
        const Value other = signed_operand();
        value = times ? numbers_.multiply(value, other) : numbers_.divide(value, other);
    }
    return value;
}

template <class Numbers>
auto ExactExpressions<Numbers>::operand(TokenReader& tokens) -> Value {
    const Token token = tokens.take();
    if (token.is('(')) {
        const Value value = read(tokens);
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
        if (*value == 0) return numbers_.whole(0);
        return numbers_.decimal(std::string(token.text));
    }
    return named(tokens, token);
}

template <class Numbers>
auto ExactExpressions<Numbers>::named(TokenReader& tokens, const Token& word) -> Value {
    if (word.text == "pi") return numbers_.pi();
    if (word.text == "phi")
        return numbers_.divide(
            numbers_.add(numbers_.whole(1), numbers_.square_root(numbers_.whole(5))),
            numbers_.whole(2));
    const bool function =
        word.text == "sqrt" || word.text == "sin" || word.text == "cos" || word.text == "tan";
    if (!function) return constant(std::string(word.text));
    tokens.expect('(');
    const Value argument = read(tokens);
    tokens.expect(')');
    if (word.text == "sqrt") return numbers_.square_root(argument);
    if (word.text == "sin") return numbers_.sine(argument);
    if (word.text == "cos") return numbers_.cosine(argument);
    const Value cosine = numbers_.cosine(argument);
    return numbers_.divide(numbers_.sine(argument), cosine);
}

template <class Numbers>
auto ExactExpressions<Numbers>::constant(const std::string& name) -> Value {
    const auto known = known_.find(name);
    if (known != known_.end()) return known->second;
    const auto let = lets_.find(name);
    if (let == lets_.end()) throw NotExact{"'" + name + "' changes with time"};
    if (++depth_ > deepest_let) throw NotExact{"'let's nested too deeply"};
    Diagnostics unused;
    TokenReader tokens(let->second.text, let->second.file, unused);
    const Value value = read(tokens);
    --depth_;
    known_.emplace(name, value);
    return value;
}

template class ExactExpressions<FieldNumbers>;
template class ExactExpressions<BallNumbers>;

}  // namespace pxm::host
