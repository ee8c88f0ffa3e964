#include "pxm/dsp32/assembler/lexer.hpp"

#include <array>
#include <charconv>

namespace pxm::dsp32::assembler {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.';
}

// The longer one first where one starts with another.
constexpr std::array<std::string_view, 24> signs{">>>", "<<<", "++", "--", ">>", ">=", "&~", ">",
                                                 "<",   "+",   "-",  "*",  "/",  "(",  ")",  "=",
                                                 ",",   ":",   "#",  "&",  "^",  "|",  "@",  "\""};

class Lexer {
  public:
    Lexer(std::string_view source, Mistakes& mistakes) : source_(source), mistakes_(mistakes) {}

    std::vector<Line> lines() {
        while (at_ < source_.size() && !mistakes_.full()) next();
        end_line();
        return std::move(lines_);
    }

  private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0';
    }
    [[nodiscard]] Place place() const { return {line_, static_cast<int>(at_ - line_start_) + 1}; }

    void next() {
        const char c = peek();
        if (c == '\n') {
            end_line();
            new_line();
        } else if (c == ' ' || c == '\t' || c == '\r') {
            ++at_;
        } else if (c == '/' && peek(1) == '/') {
            while (at_ < source_.size() && peek() != '\n') ++at_;
        } else if (c == '/' && peek(1) == '*') {
            skip_comment();
        } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
            take_number();
        } else if (is_letter(c)) {
            std::size_t length = 1;
            while (is_letter(peek(length)) || is_digit(peek(length))) ++length;
            take(TokenKind::name, length);
        } else {
            take_sign();
        }
    }
    void new_line() {
        ++at_;
        ++line_;
        line_start_ = at_;
    }
    void skip_comment() {
        const Place start = place();
        at_ += 2;
        while (at_ < source_.size() && !(peek() == '*' && peek(1) == '/')) {
            if (peek() == '\n') {
                new_line();
            } else {
                ++at_;
            }
        }
        if (at_ >= source_.size()) {
            mistakes_.add(start, "this comment has no end");
        } else {
            at_ += 2;
        }
    }
    Token& take(TokenKind kind, std::size_t length) {
        line_tokens_.push_back({kind, source_.substr(at_, length), place(), 0, 0});
        at_ += length;
        return line_tokens_.back();
    }
    void take_sign() {
        for (const std::string_view sign : signs) {
            if (!source_.substr(at_).starts_with(sign)) continue;
            take(TokenKind::sign, sign.size());
            return;
        }
        mistakes_.add(place(), "a character that means nothing here");
        ++at_;
    }
    void take_number() {
        std::size_t length = 0;
        const auto in_number = [&](char c) {
            const char before = length > 0 ? peek(length - 1) : '\0';
            const bool exponent = (before == 'e' || before == 'E') && !hexadecimal();
            return is_digit(c) || is_letter(c) || (exponent && (c == '+' || c == '-'));
        };
        while (in_number(peek(length))) ++length;
        const bool hex = hexadecimal();
        Token& token = take(TokenKind::integer, length);
        const std::string_view digits = token.text.substr(hex ? 2 : 0);
        const char* end = digits.data() + digits.size();
        const auto whole = std::from_chars(digits.data(), end, token.integer, hex ? 16 : 10);
        token.real = static_cast<double>(token.integer);
        if (whole.ec == std::errc{} && whole.ptr == end) return;
        token.kind = TokenKind::real;
        const auto real = std::from_chars(digits.data(), end, token.real);
        if (hex || real.ec != std::errc{} || real.ptr != end)
            mistakes_.add(token.place, "this is no number");
    }
    [[nodiscard]] bool hexadecimal() const {
        return peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
    }
    void end_line() {
        if (line_tokens_.empty()) return;
        line_tokens_.push_back({TokenKind::end, {}, place(), 0, 0});
        lines_.push_back(std::move(line_tokens_));
        line_tokens_ = {};
    }

    std::string_view source_;
    Mistakes& mistakes_;
    std::size_t at_ = 0;
    std::size_t line_start_ = 0;
    int line_ = 1;
    Line line_tokens_;
    std::vector<Line> lines_;
};

}  // namespace

std::vector<Line> lines_of(std::string_view source, Mistakes& mistakes) {
    return Lexer(source, mistakes).lines();
}

}  // namespace pxm::dsp32::assembler
