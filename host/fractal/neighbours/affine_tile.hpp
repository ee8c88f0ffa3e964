// Self-affine tiles: maps of one linear part, whose inverse keeps a lattice that has the maps'
// digits, as many as its determinant says. Where no two words are the same map, they have an
// inside, and no two of their cells share any of it [LaWa96].
#pragma once

#include "host/fractal/exact/exact_system.hpp"

namespace pxm::host {

/// Whether x -> A^-1 (x + d) are the system's maps, of a linear A and with as many d as |det A|,
/// and the differences of the d generate, with A, a lattice of the whole space. `system` is of one
/// follow set.
[[nodiscard]] bool has_lattice_digits(const exact::ExactSystem& system);

}  // namespace pxm::host
