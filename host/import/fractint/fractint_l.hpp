// FRACTINT's .l files: L-systems (docs/import.md).
//   name { Angle n   Axiom s   X=s ... }
// The case of letters does not matter. F and D draw, G and M move, + and - turn by 360/n degrees to
// the left and right, \n and /n by n degrees, | turns round, ! exchanges left and right, [ ] push
// and pop, @n multiplies the step. Colours (C < >) are ignored.
//   name (3D) { Degrees d or Angle n   Axiom s   X=s ... }
// is a turtle in space, as [ABOP] has it: & ^ pitch, \ / roll, F draws and f moves.
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
    std::string degrees;          // of an entry in space, which may say them: as written
    std::optional<FractintWord> axiom;
    std::map<char, FractintWord> rules;
};

/// Whether the entry is of a turtle in space.
[[nodiscard]] bool is_in_space(const FractintL& l);

/// The entries of a file, comment entries left out. Mistakes inside an entry are kept with it,
/// others go to `diagnostics`.
[[nodiscard]] std::vector<FractintL> parse_fractint_l(std::string_view text,
                                                      Diagnostics& diagnostics);

/// The entry as turtle commands. What is wrong with them is added to the entry's diagnostics; then
/// the result cannot be used.
[[nodiscard]] Lsystem lsystem_of(FractintL& l);

}  // namespace pxm::host
