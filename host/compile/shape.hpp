// The master object of a system: its maps, graph and volumes in coordinates of their own.
#pragma once

#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// The similarity from a shape's own coordinates (its ball about the unit ball) to those of its
/// ifs.
struct ShapeFrame {
    glm::dvec3 center{0.0};
    double scale = 1;
};

[[nodiscard]] ShapeFrame frame_around(const Ball& ball);

/// The power of two nearest to x; 1 if x is no size.
[[nodiscard]] double power_of_two_near(double x);

/// The method for a system where the scene leaves it open: the product is exact for similitudes.
[[nodiscard]] kernels::Lipschitz choose_lipschitz(LipschitzMethod method, const Rifs& rifs);

[[nodiscard]] double constant_by(kernels::Lipschitz method, const Affine& map);

/// The shape of a system, without colours. One volume per follow set, in the system's coordinates.
[[nodiscard]] CompiledShape make_shape(const Rifs& rifs, const std::vector<CompiledVolume>& volumes,
                                       const ShapeFrame& frame, kernels::Lipschitz method);

}  // namespace pxm::host
