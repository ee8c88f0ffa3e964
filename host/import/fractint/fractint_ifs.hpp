// FRACTINT's .ifs files: affine maps by numbers (docs/import.md).
//   name { a b c d e f p ... }       x' = a x + b y + e, y' = c x + d y + f
//   name (3D) { 9 numbers by rows, 3 of translation, p ... }
// The oldest files hold the numbers of one system and nothing else.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/import/fractint/fractint_reader.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

struct FractintIfs {
    FractintEntry entry;           // its name is empty where a file holds numbers alone
    bool flat = true;              // 7 numbers a map, else 13
    bool weighted = true;          // else every line is a map without its probability
    std::vector<double> numbers;   // a whole number of maps, if there were no errors
    std::vector<Position> places;  // of the numbers
};

/// The entries of a file, comment entries left out. Mistakes inside an entry are kept with it,
/// others go to `diagnostics`.
[[nodiscard]] std::vector<FractintIfs> parse_fractint_ifs(std::string_view text,
                                                          Diagnostics& diagnostics);

/// The maps as a block without a name. A flat entry becomes a system in the plane z = 0 whose maps
/// scale z by sqrt |det| of their plane part, which no product of maps exceeds in its Lipschitz
/// constant. Precondition: the entry has no errors.
[[nodiscard]] IfsBlock fractint_maps(const FractintIfs& ifs);

}  // namespace pxm::host
