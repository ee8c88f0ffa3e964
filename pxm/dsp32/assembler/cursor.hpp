// Reading one line of tokens from left to right, and the constant expressions in it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "pxm/dsp32/assembler/lexer.hpp"

namespace pxm::dsp32::assembler {

/// The value of a name, if it has one (by now).
using ValueOf = std::function<std::optional<std::int64_t>(std::string_view name)>;

/// Numbers beyond this are a mistake: no address, constant or repetition is near it.
inline constexpr std::int64_t largest_number = std::int64_t{1} << 40;

/// A register as written: its code, and the letter behind its number that says what of it is meant.
struct RegisterName {
    unsigned code = 0;  // of five bits, as isa::register_names counts
    char suffix = 0;    // 0, h, l, e
};
/// Nothing: the name is no register's.
[[nodiscard]] std::optional<RegisterName> register_of(std::string_view name);

/// The number of an accumulator.
[[nodiscard]] std::optional<unsigned> accumulator_of(std::string_view name);

/// A place in a line. What fails says why, once, and is empty from then on.
class Cursor {
  public:
    /// At the beginning of a line; mistakes are added to the last.
    Cursor(const Line& line, const ValueOf& value_of, Mistakes& mistakes)
        : line_(line), value_of_(value_of), mistakes_(mistakes) {}

    /// The token so many places ahead, or the end of the line.
    [[nodiscard]] const Token& peek(std::size_t ahead = 0) const {
        return line_[std::min(at_ + ahead, line_.size() - 1)];
    }
    /// Whether all tokens are taken.
    [[nodiscard]] bool at_end() const { return peek().kind == TokenKind::end; }
    /// The next token, which is behind then.
    const Token& take() {
        const Token& token = peek();
        if (!at_end()) ++at_;
        return token;
    }
    /// Takes the token if it is that one.
    bool accept(std::string_view text) {
        if (!peek().is(text)) return false;
        ++at_;
        return true;
    }
    /// Takes the token, or complains.
    bool expect(std::string_view text);
    /// Complains unless the line is over.
    bool expect_end();
    /// A mistake at the token ahead.
    std::nullopt_t fail(const std::string& message) { return fail(peek().place, message); }
    /// A mistake at a place; always nothing.
    std::nullopt_t fail(Place place, const std::string& message) {
        if (!failed_) mistakes_.add(place, message);
        failed_ = true;
        return std::nullopt;
    }
    [[nodiscard]] bool failed() const { return failed_; }  // whether it has complained

    /// A register, taken if one is ahead.
    std::optional<RegisterName> accept_register();
    /// A constant expression: + - * / ( ), integers and names. Ends before `- rN`.
    std::optional<std::int64_t> expression();
    /// The same, with limits.
    std::optional<std::int64_t> expression(std::int64_t least, std::int64_t most,
                                           std::string_view what);
    /// A number with a fraction: an optional sign and a number, real or integer.
    std::optional<double> real_number();

  private:
    std::optional<std::int64_t> product();
    std::optional<std::int64_t> factor();
    std::optional<std::int64_t> named(const Token& token);
    std::optional<std::int64_t> in_reach(std::int64_t number, Place place);

    const Line& line_;
    const ValueOf& value_of_;
    Mistakes& mistakes_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool failed_ = false;
};

/// A text as a message shows it, and a token.
[[nodiscard]] std::string quoted(std::string_view text);
[[nodiscard]] std::string shown(const Token& token);  // the same of a token

}  // namespace pxm::dsp32::assembler
