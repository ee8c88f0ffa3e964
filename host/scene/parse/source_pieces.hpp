// A scene's text as its tokens with what stands between them, which the parser skips: comments,
// ends of lines, blanks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/scene/parse/lexer.hpp"

namespace pxm::host {

struct Comment {
    std::string text;  // with its '#', without blanks at the end
    int newlines_before = 0;
    bool operator==(const Comment&) const = default;
};

/// What stands between two tokens.
struct Gap {
    std::vector<Comment> comments;
    int newlines = 0;  // after the last comment
    int blanks = 0;    // after the last newline

    /// Whether the tokens stand on different lines.
    [[nodiscard]] bool breaks() const { return newlines > 0 || !comments.empty(); }
};

struct Piece {
    TokenKind kind = TokenKind::end;
    std::string text;  // a string's with its quotes
    Gap before;

    [[nodiscard]] bool is(std::string_view other) const { return text == other; }
};

/// All tokens of the text; the last is `end`.
[[nodiscard]] std::vector<Piece> pieces_of(std::string_view text);

}  // namespace pxm::host
