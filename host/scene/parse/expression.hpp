// Constant expressions: + - * / ( ), unary minus, sqrt sin cos tan (degrees), pi, phi, `let` names.
#pragma once

#include <string>
#include <unordered_map>

#include "host/scene/parse/token_reader.hpp"

namespace pxm::host {

/// The numbers named by `let` so far.
using Constants = std::unordered_map<std::string, double>;

/// Reads one expression; its value is finite. Throws SyntaxError after reporting a mistake.
[[nodiscard]] double parse_expression(TokenReader& tokens, const Constants& constants);

}  // namespace pxm::host
