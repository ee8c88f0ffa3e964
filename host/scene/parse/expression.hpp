// Constant expressions: + - * / ( ), unary minus, sqrt sin cos tan (degrees), pi, phi, `let` names,
// and key(...), a number that changes with another one, as with the time of an animation.
#pragma once

#include <string>
#include <unordered_map>

#include "host/scene/parse/token_reader.hpp"

namespace pxm::host {

/// The numbers named by `let` so far, and those of the frame after an `animation`.
using Constants = std::unordered_map<std::string, double>;

/// What may stand behind an expression. A word with a colon behind it is no number but the next
/// directive, unless it is the colon that ends the expression: key(t: ...).
enum class Behind { anything, colon };

/// Reads one expression; its value is finite. Throws SyntaxError after reporting a mistake.
[[nodiscard]] double parse_expression(TokenReader& tokens, const Constants& constants,
                                      Behind behind = Behind::anything);

}  // namespace pxm::host
