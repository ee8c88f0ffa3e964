// How likely each map is in the chaos game where the scene does not say it, so that points cover
// the attractor evenly (Sec. 7.2.1).
#pragma once

#include <vector>

#include "host/fractal/rifs.hpp"

namespace pxm::host {

/// What a map's image takes of the attractor: by how much the map shrinks lengths, areas or
/// volumes, as many dimensions as what it is applied to has (of a point: volumes); with a graph,
/// times the share of what may stand inside it, the dominant eigenvector of these factors between
/// the follow sets of a component. No less than a thousandth of the largest beside it, so that no
/// map is starved. Precondition: the system contracts.
[[nodiscard]] std::vector<double> default_weights(const Rifs& rifs);

}  // namespace pxm::host
