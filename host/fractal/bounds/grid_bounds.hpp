// Bounds from the support functions on a grid of directions, for systems that a descent with a
// budget leaves loose.
#pragma once

#include "host/fractal/bounds/approximation.hpp"

namespace pxm::host {

/// Gives `known` a grid, shrinks its balls by it, and adds points that reach far. Does nothing for
/// systems of more than a few thousand maps.
void refine_by_grid(const Rifs& rifs, Approximation& known);

}  // namespace pxm::host
