// The box of the union of a set's images, iterated: what is left where contraction is slow and a
// descent with a budget stays loose (thesis-notes, "After the thesis").
#pragma once

#include <vector>

#include "host/fractal/bounds/bounds.hpp"

namespace pxm::host {

/// Shrinks each box to what the images of the balls and boxes inside it need, again and again.
void shrink_boxes(const Rifs& rifs, std::vector<Bounds>& bounds);

}  // namespace pxm::host
