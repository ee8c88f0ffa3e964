// The box of the union of a set's images, iterated: what is left where contraction is slow and a
// descent with a budget stays loose (thesis-notes, "After the thesis").
#pragma once

#include "host/fractal/bounds/approximation.hpp"

namespace pxm::host {

/// Shrinks each box to what the images of the balls and boxes inside it need, again and again; and
/// so, every step rounded outward, the sure boxes.
void shrink_boxes(const Rifs& rifs, Approximation& known);

/// By how much a sure box sticks out of a box.
[[nodiscard]] double shortfall_of_box(const Box& box, const Box& sure);

}  // namespace pxm::host
