// The tokens of one file with lookahead, and the parser's way of failing: a mistake is
// reported and SyntaxError thrown; whoever can go on catches it.
#pragma once

#include <string>
#include <string_view>

#include "host/scene/diagnostics.hpp"
#include "host/scene/parse/lexer.hpp"

namespace pxm::host {

/// The mistake has been reported already.
struct SyntaxError {};

class TokenReader {
  public:
    TokenReader(std::string_view text, int file, Diagnostics& diagnostics);

    [[nodiscard]] const Token& peek() const { return next_; }
    [[nodiscard]] const Token& peek_second() const { return second_; }
    /// The token after peek_second(); it is read anew at every call.
    [[nodiscard]] Token peek_third() const { return Lexer(lexer_).next(); }
    Token take();
    /// Tokens taken so far: tells whether anything was consumed.
    [[nodiscard]] long taken() const { return taken_; }

    /// Takes the symbol if it is next.
    bool accept(char symbol);
    /// Takes the symbol or fails; `note` says what the directive wants.
    Token expect(char symbol, std::string_view note = {});

    /// Adds an error and goes on.
    void report(const Position& position, const std::string& message);
    [[noreturn]] void fail(const Position& position, const std::string& message);
    /// "expected WHAT, found 'x'", with the note in parentheses.
    [[noreturn]] void fail_expected(std::string_view what, std::string_view note = {});
    /// From here on there is only the end of the file, and nothing more is reported.
    void give_up();

  private:
    Lexer lexer_;
    Diagnostics& diagnostics_;
    Token next_;
    Token second_;
    long taken_ = 0;
    bool given_up_ = false;
};

}  // namespace pxm::host
