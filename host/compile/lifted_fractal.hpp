// A fractal ready to be rendered: shown to contract, and with inverses for all its maps. A singular
// map has none, yet its image is part of the attractor: it is lifted, that is, given a thickness
// along the axes that it squashes to nothing (dsp_kernels/flatness.hpp keeps it there).
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "host/compile/proven_rifs.hpp"
#include "host/fractal/bounds/bounds.hpp"

namespace pxm::host {

inline constexpr double first_lift = 1e-4;  // share of a set that a lifted map leaves it at first

/// An ifs block with what mathematics knows of it.
struct Fractal {
    Rifs exact;  // as written
    Rifs rifs;   // singular maps lifted
    bool lifted = false;
    Contraction contraction;
    std::vector<Bounds> bounds;  // empty until an object needs them
};

/// The fractal of a block, singular maps lifted by first_lift. Nothing if the block has an error.
[[nodiscard]] std::optional<Fractal> make_fractal(const IfsBlock& block, Diagnostics& diagnostics);

/// Lifts the singular maps to another share of a set, within reason, and bounds the fractal again.
void lift_again(Fractal& fractal, double share);

/// The unit axes that a singular map squashes to nothing; none for a regular map.
[[nodiscard]] std::vector<glm::dvec3> lost_axes(const Affine& map);

/// The smallest extent, along the axes that singular maps squash, of what may stand inside them;
/// infinite if there is none. Needs the bounds.
[[nodiscard]] double squashed_extent(const Fractal& fractal);

}  // namespace pxm::host
