#include "host/scene/parse/lexer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// The power of ten of the first digit that is not zero, as in 0.00123e5 -> 2; clamped.
long decimal_magnitude(std::string_view text) {
    const std::size_t exponent_at = text.find_first_of("eE");
    const std::string_view mantissa = text.substr(0, exponent_at);
    const std::size_t first = mantissa.find_first_of("123456789");
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    if (first == std::string_view::npos) return 0;
    constexpr long clamp = 1'000'000'000;  // beyond any file's digits
    long exponent = 0;
    if (exponent_at != std::string_view::npos) {
        std::string_view digits = text.substr(exponent_at + 1);
        const bool negative = digits.starts_with('-');
        if (negative || digits.starts_with('+')) digits.remove_prefix(1);
        for (const char digit : digits) exponent = std::min(clamp, exponent * 10 + (digit - '0'));
        if (negative) exponent = -exponent;
    }
    return static_cast<long>(point) - static_cast<long>(first) + exponent;
}

}  // namespace

std::string describe(const Token& token) {
    switch (token.kind) {
        case TokenKind::end:
            return "the end of the file";
        case TokenKind::string:
            return fmt::format("\"{}\"", printable(token.text));
        case TokenKind::bad:
            break;
        default:
            return fmt::format("'{}'", printable(token.text));
    }
    const char first = token.text.front();
    if (first == '"') return "a string without its closing '\"'";
    if (printable_length(token.text, 0) == 1) return fmt::format("'{}'", first);
    return fmt::format("byte 0x{:02X}", static_cast<unsigned char>(first));
}

std::optional<double> number_value(std::string_view text) {
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec == std::errc{}) return value;
    if (decimal_magnitude(text) > 0) return std::nullopt;
    return 0.0;
}

Lexer::Lexer(std::string_view text, int file) : text_(text) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    position_.file = file;
}

Token Lexer::next() {
    skip_blanks();
    position_.column = static_cast<int>(place_ - line_start_) + 1;
    Token token;
    token.position = position_;
    if (place_ >= text_.size()) return token;
    const char c = text_[place_];
    if (is_word_start(c)) {
        std::size_t end = place_;
        while (is_word_start(at(end)) || is_digit(at(end))) ++end;
        return take(token, TokenKind::word, end);
    }
    if (is_digit(c) || (c == '.' && is_digit(at(place_ + 1))))
        return take(token, TokenKind::number, number_end(place_));
    if (c == '"') return string(token);
    if (c == '-' && at(place_ + 1) == '>') return take(token, TokenKind::arrow, place_ + 2);
    const bool known = std::string_view("{}(),:=+-*/").find(c) != std::string_view::npos;
    return take(token, known ? TokenKind::symbol : TokenKind::bad, place_ + 1);
}

void Lexer::skip_blanks() {
    while (place_ < text_.size()) {
        const char c = text_[place_];
        if (c == '#') {
            place_ = std::min(text_.find('\n', place_), text_.size());
        } else if (c == '\n') {
            ++position_.line;
            line_start_ = ++place_;
        } else if (c == ' ' || c == '\t' || c == '\r') {
            ++place_;
        } else {
            return;
        }
    }
}

/// digits [. digits] [e [sign] digits]; an 'e' without digits belongs to what follows.
std::size_t Lexer::number_end(std::size_t place) const {
    while (is_digit(at(place))) ++place;
    if (at(place) == '.') ++place;
    while (is_digit(at(place))) ++place;
    if (at(place) != 'e' && at(place) != 'E') return place;
    std::size_t exponent = place + 1;
    if (at(exponent) == '+' || at(exponent) == '-') ++exponent;
    if (!is_digit(at(exponent))) return place;
    while (is_digit(at(exponent))) ++exponent;
    return exponent;
}

/// A string ends on its line and has no escapes.
Token Lexer::string(Token token) {
    const std::size_t end = text_.find_first_of("\"\r\n", place_ + 1);
    if (end == std::string_view::npos || text_[end] != '"')
        return take(token, TokenKind::bad, std::min(end, text_.size()));
    token = take(token, TokenKind::string, end + 1);
    token.text = token.text.substr(1, token.text.size() - 2);
    return token;
}

Token Lexer::take(Token token, TokenKind kind, std::size_t end) {
    token.kind = kind;
    token.text = text_.substr(place_, end - place_);
    place_ = end;
    return token;
}

}  // namespace pxm::host
