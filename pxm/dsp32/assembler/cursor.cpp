#include "pxm/dsp32/assembler/cursor.hpp"

#include <algorithm>

#include "pxm/dsp32/isa/names.hpp"

namespace pxm::dsp32::assembler {

namespace {

constexpr int deepest_parentheses = 50;

bool is_register_word(std::string_view name) {
    return name.starts_with('r') || name.starts_with("pc") || name.starts_with("dauc") ||
           name.starts_with("ioc");
}

}  // namespace

std::optional<RegisterName> register_of(std::string_view name) {
    if (!is_register_word(name)) return std::nullopt;
    if (const auto code = isa::code_of(isa::register_names, name)) return RegisterName{*code, 0};
    const char last = name.back();
    if (last != 'h' && last != 'l' && last != 'e') return std::nullopt;
    const auto code = isa::code_of(isa::register_names, name.substr(0, name.size() - 1));
    if (!code) return std::nullopt;
    return RegisterName{*code, last};
}

std::optional<unsigned> accumulator_of(std::string_view name) {
    if (name.size() != 2 || name[0] != 'a' || name[1] < '0' || name[1] > '3') return std::nullopt;
    return static_cast<unsigned>(name[1] - '0');
}

std::string quoted(std::string_view text) {
    std::string result(1, '"');
    result += text;
    return result += '"';
}

std::string shown(const Token& token) {
    if (token.kind == TokenKind::end) return "the end of the line";
    return quoted(token.text);
}

bool Cursor::expect(std::string_view text) {
    if (accept(text)) return true;
    fail("expected " + quoted(text) + ", found " + shown(peek()));
    return false;
}

bool Cursor::expect_end() {
    if (at_end()) return true;
    fail("expected the end of the line, found " + shown(peek()));
    return false;
}

std::optional<RegisterName> Cursor::accept_register() {
    if (peek().kind != TokenKind::name) return std::nullopt;
    const auto found = register_of(peek().text);
    if (found) take();
    return found;
}

std::optional<std::int64_t> Cursor::in_reach(std::int64_t number, Place place) {
    if (number >= -largest_number && number <= largest_number) return number;
    return fail(place, "this number is beyond all limits");
}

std::optional<std::int64_t> Cursor::expression() {
    const Place place = peek().place;
    auto sum = product();
    while (sum && (peek().is("+") || peek().is("-"))) {
        if (peek(1).kind == TokenKind::name && register_of(peek(1).text)) break;
        const bool minus = take().is("-");
        const auto next = product();
        if (!next) return std::nullopt;
        sum = in_reach(minus ? *sum - *next : *sum + *next, place);
    }
    return sum;
}

std::optional<std::int64_t> Cursor::product() {
    const Place place = peek().place;
    auto result = factor();
    while (result && (peek().is("*") || peek().is("/"))) {
        const bool division = take().is("/");
        const auto next = factor();
        if (!next) return std::nullopt;
        if (division && *next == 0) return fail(place, "a division by zero");
        // Both are below 2^41: the product is looked at before it is computed.
        if (!division && *next != 0 && std::abs(*result) > largest_number / std::abs(*next))
            return fail(place, "this number is beyond all limits");
        result = division ? *result / *next : *result * *next;
    }
    return result;
}

std::optional<std::int64_t> Cursor::factor() {
    if (depth_ > deepest_parentheses) return fail("too many parentheses or signs");
    const Token& token = take();
    if (token.is("-") || token.is("+")) {
        ++depth_;
        const auto value = factor();
        --depth_;
        if (!value) return std::nullopt;
        return token.is("-") ? -*value : *value;
    }
    if (token.is("(")) {
        ++depth_;
        const auto value = expression();
        --depth_;
        if (!value || !expect(")")) return std::nullopt;
        return value;
    }
    if (token.kind == TokenKind::integer) return in_reach(token.integer, token.place);
    if (token.kind == TokenKind::name) return named(token);
    return fail(token.place, "expected a number or a name, found " + shown(token));
}

std::optional<std::int64_t> Cursor::named(const Token& token) {
    if (register_of(token.text) || accumulator_of(token.text))
        return fail(token.place, "a register cannot stand here");
    if (const auto value = value_of_(token.text)) return value;
    return fail(token.place, "there is no " + quoted(token.text));
}

std::optional<std::int64_t> Cursor::expression(std::int64_t least, std::int64_t most,
                                               std::string_view what) {
    const Place place = peek().place;
    const auto value = expression();
    if (!value) return std::nullopt;
    if (*value >= least && *value <= most) return value;
    return fail(place, std::string(what) + " is out of range: " + std::to_string(*value) +
                           ", allowed are " + std::to_string(least) + " to " +
                           std::to_string(most));
}

std::optional<double> Cursor::real_number() {
    const bool negative = peek().is("-");
    if (negative || peek().is("+")) take();
    const Token& token = take();
    if (token.kind != TokenKind::integer && token.kind != TokenKind::real)
        return fail(token.place, "expected a number, found " + shown(token));
    return negative ? -token.real : token.real;
}

}  // namespace pxm::dsp32::assembler
