// FRACTINT's .l files: L-systems (docs/import.md).
//   name { Angle n   Axiom s   X=s ... }
// The case of letters does not matter. F and D draw, G and M move, + and - turn by 360/n degrees to
// the left and right, \n and /n by n degrees, | turns round, ! exchanges left and right, [ ] push
// and pop, @n multiplies the step. Colours (C < >) are ignored.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "host/import/fractint/fractint_reader.hpp"
#include "host/import/lsystem/lsystem.hpp"

namespace pxm::host {

/// The characters of an axiom or a rule, blanks left out, each with its place.
struct FractintWord {
    std::string text;
    std::vector<Position> places;
    Position position;
};

struct FractintL {
    FractintEntry entry;
    std::optional<double> angle;  // the n of 360/n
    std::optional<FractintWord> axiom;
    std::map<char, FractintWord> rules;
};

/// The entries of a file, comment entries left out. Mistakes inside an entry are kept with it,
/// others go to `diagnostics`.
[[nodiscard]] std::vector<FractintL> parse_fractint_l(std::string_view text,
                                                      Diagnostics& diagnostics);

/// The entry as turtle commands. What is wrong with them is added to the entry's diagnostics; then
/// the result cannot be used.
[[nodiscard]] Lsystem lsystem_of(FractintL& l);

}  // namespace pxm::host
