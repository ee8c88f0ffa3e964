#include "host/scene/parse/value_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr double whole_limit = 1e15;  // every whole number up to here is a double

/// Whether key(...) is next, and nothing is computed of it.
bool is_key_alone(const TokenReader& tokens) {
    if (!tokens.peek().is_word("key") || !tokens.peek_second().is('(')) return false;
    TokenReader ahead = tokens;
    ahead.take();
    long depth = 0;
    do {
        const Token token = ahead.take();
        if (token.kind == TokenKind::end) return true;  // said where it is read
        if (token.is('(')) ++depth;
        if (token.is(')')) --depth;
    } while (depth > 0);
    const Token& behind = ahead.peek();
    return !behind.is('+') && !behind.is('-') && !behind.is('*') && !behind.is('/');
}

}  // namespace

long ValueReader::whole_number() {
    const Position position = tokens_.peek().position;
    const double value = number();
    if (std::abs(value) > whole_limit || value != std::trunc(value))
        tokens_.fail(position, fmt::format("expected a whole number, found {}", value));
    return static_cast<long>(value);
}

Decimal ValueReader::decimal() {
    const Token first = tokens_.peek();
    const Token second = tokens_.peek_second();
    const long taken = tokens_.taken();
    Decimal decimal{number(), {}};
    const long length = tokens_.taken() - taken;
    if (length == 1 && first.kind == TokenKind::number) decimal.text = first.text;
    if (length == 2 && second.kind == TokenKind::number)
        decimal.text = fmt::format("{}{}", first.is('-') ? "-" : "", second.text);
    return decimal;
}

double ValueReader::magnification() {
    // Keys within a larger expression are as those of all numbers.
    if (!is_key_alone(tokens_)) return number();
    tokens_.take();
    return read_keys<1>(
        tokens_, Interpolation::exponential, [&] { return std::array{number()}; },
        [&](Behind behind) { return parse_expression(tokens_, constants_, behind); })[0];
}

bool ValueReader::keys_are_points() const {
    if (!tokens_.peek().is_word("key") || !tokens_.peek_second().is('(')) return false;
    TokenReader ahead = tokens_;
    while (ahead.peek().kind != TokenKind::arrow) {
        if (ahead.take().kind == TokenKind::end) return false;
    }
    ahead.take();
    // A comma inside of the first parentheses makes a point of them.
    for (long depth = 0; ahead.peek().kind != TokenKind::end;) {
        const Token token = ahead.take();
        if (token.is('(')) ++depth;
        if (token.is(')')) --depth;
        if (token.is(',') && depth == 1) return true;
        if (depth <= 0) return false;
    }
    return false;
}

void ValueReader::end_of_list(std::string_view note) {
    if (tokens_.peek().is(','))
        tokens_.fail(tokens_.peek().position, fmt::format("one value too many ({})", note));
}

glm::dvec2 ValueReader::vec2(std::string_view note) {
    const auto v = numbers<2>(note);
    return {v[0], v[1]};
}

glm::dvec3 ValueReader::vec3(std::string_view note) {
    const auto v = numbers<3>(note);
    return {v[0], v[1], v[2]};
}

glm::dvec4 ValueReader::rgba() {
    const auto v = numbers<4>("this color is r,g,b,a");
    return {v[0], v[1], v[2], v[3]};
}

DecimalVec3 ValueReader::decimals(std::string_view note) {
    DecimalVec3 values;
    if (keys_are_points()) {
        const glm::dvec3 point = vec3(note);
        for (int i = 0; i < 3; ++i) values[static_cast<std::size_t>(i)] = {point[i], {}};
        return values;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) tokens_.expect(',', note);
        values[i] = decimal();
    }
    end_of_list(note);
    return values;
}

glm::dvec3 ValueReader::scale_factors() {
    constexpr std::string_view note = "'scale' takes one number or sx,sy,sz";
    if (keys_are_points()) return vec3(note);
    const double x = number();
    if (!tokens_.accept(',')) return glm::dvec3{x};
    const double y = number();
    tokens_.expect(',', note);
    const double z = number();
    end_of_list(note);
    return {x, y, z};
}

glm::dvec3 ValueReader::point() {
    constexpr std::string_view note = "a point is (x,y,z)";
    const auto value = in_parentheses<3>(note);
    return {value[0], value[1], value[2]};
}

std::string ValueReader::name(std::string_view what) {
    const Token& token = tokens_.peek();
    const std::string expected = fmt::format("the name of {}", what);
    if (token.kind != TokenKind::word) tokens_.fail_expected(expected);
    if (is_keyword(token.text)) tokens_.fail_expected(expected, "a keyword cannot be a name");
    return std::string(tokens_.take().text);
}

MapReference ValueReader::map_reference() {
    constexpr std::string_view expected = "a map's name or number";
    const Token token = tokens_.peek();
    MapReference reference{{}, token.position};
    if (token.kind == TokenKind::number) {
        const double number = number_value(token.text).value_or(0.5);
        if (number != std::trunc(number) || number > whole_limit) tokens_.fail_expected(expected);
        reference.map = static_cast<long>(number);
        tokens_.take();
    } else if (token.kind == TokenKind::word && !is_keyword(token.text)) {
        reference.map = std::string(tokens_.take().text);
    } else {
        tokens_.fail_expected(expected);
    }
    return reference;
}

std::vector<MapReference> ValueReader::map_references() {
    std::vector<MapReference> references{map_reference()};
    while (tokens_.accept(',')) references.push_back(map_reference());
    return references;
}

std::string ValueReader::file_name() {
    if (tokens_.peek().kind != TokenKind::string) tokens_.fail_expected("a file name in quotes");
    return std::string(tokens_.take().text);
}

std::string ValueReader::hyphenated() {
    if (tokens_.peek().kind != TokenKind::word) return {};
    std::string text(tokens_.take().text);
    while (tokens_.peek().is('-') && tokens_.peek_second().kind == TokenKind::word) {
        tokens_.take();
        text += '-';
        text += tokens_.take().text;
    }
    return text;
}

std::string ValueReader::quoted(const std::string& text) {
    return fmt::format("'{}'", printable(text));
}

}  // namespace pxm::host
