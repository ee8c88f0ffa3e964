// Where in a pixel its eye rays go: one table for all pixels, which the host broadcasts.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace pxm::host {

/// `count` places in the unit square, stratified: of count columns and of count rows of equal width
/// each holds one, at its middle, and they are spread as evenly as van der Corput's sequence. The
/// first place is the one nearest to the centre; a single one is the centre. Precondition: count >
/// 0.
[[nodiscard]] std::vector<glm::dvec2> sample_places(long count);

/// Moves the places by a sixty-fourth of a pixel, in no round direction. Cells whose faces are
/// askew find the face between them each by its own rounding; a ray that lies in it by design, as
/// seen along an axis, would pass between them, or show whichever cell rounding lets it come to
/// first.
void leave_faces(std::vector<glm::dvec2>& places);

}  // namespace pxm::host
