// A reference of higher precision than double: the nodes' program in long double, which is 64 bits
// of mantissa on an x86-64 and 113 where it is a quadruple.
#pragma once

#include "host/render/render.hpp"

namespace pxm::host {

/// Renders in long double on one thread. p has the floor of double, so the picture is the one that
/// double is after. Throws Error as a render does.
/// `stopped` if the render was given up.
[[nodiscard]] RenderResult render_extended(const RenderRequest& request, const RunControl& control);

}  // namespace pxm::host
