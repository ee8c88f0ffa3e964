// The source of a program as lines of tokens. Comments are those of C: AT&T's assembler was fed by
// the C preprocessor [S9, S12].
#pragma once

#include <cstdint>
#include <string_view>

#include "pxm/dsp32/assembler/mistake.hpp"

namespace pxm::dsp32::assembler {

enum class TokenKind : std::uint8_t { name, integer, real, sign, end };  // what a token is

/// `text` points into the source.
struct Token {
    TokenKind kind = TokenKind::end;  // what it is
    std::string_view text;            // as written
    Place place;                      // of its first character
    std::int64_t integer = 0;         // of an integer
    double real = 0;                  // an integer token has it too

    /// Whether it is written so.
    [[nodiscard]] bool is(std::string_view what) const {
        return kind != TokenKind::end && text == what;
    }
};

/// The tokens of a line, ended by one of kind `end`.
using Line = std::vector<Token>;

/// The lines that hold anything. Precondition: `source` outlives them.
[[nodiscard]] std::vector<Line> lines_of(std::string_view source, Mistakes& mistakes);

}  // namespace pxm::dsp32::assembler
