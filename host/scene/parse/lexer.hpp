// Scene text to tokens (docs/scene-language.md, "Form"). Nothing is copied and nothing is kept:
// a token is a view into the text, and the lexer is its place in it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "host/scene/scene.hpp"

namespace pxm::host {

enum class TokenKind { word, number, string, symbol, arrow, bad, end };

struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text;  // a string's without its quotes
    Position position;

    [[nodiscard]] bool is(char symbol) const {
        return kind == TokenKind::symbol && text.front() == symbol;
    }
    [[nodiscard]] bool is_word(std::string_view word) const {
        return kind == TokenKind::word && text == word;
    }
};

/// How a message names the token: "'scale'", "the end of the file", "byte 0x93".
[[nodiscard]] std::string describe(const Token& token);

/// The value of a number token; empty if it is too large for a double. What is too small is 0.
[[nodiscard]] std::optional<double> number_value(std::string_view text);

class Lexer {
  public:
    /// `text` must outlive the lexer and its tokens. A byte order mark is skipped.
    Lexer(std::string_view text, int file);

    /// The next token; at the end of the text `end`, again and again.
    Token next();

  private:
    void skip_blanks();
    [[nodiscard]] char at(std::size_t place) const {
        return place < text_.size() ? text_[place] : '\0';
    }
    [[nodiscard]] std::size_t number_end(std::size_t place) const;
    Token string(Token token);
    Token take(Token token, TokenKind kind, std::size_t end);

    std::string_view text_;
    std::size_t place_ = 0;
    std::size_t line_start_ = 0;
    Position position_;
};

}  // namespace pxm::host
