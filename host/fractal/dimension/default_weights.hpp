// How likely each map is in the chaos game where the scene does not say it, so that points cover
// the attractor evenly (Sec. 7.2.1).
#pragma once

#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// What a map's image takes of the attractor: by how much the map shrinks lengths, areas or
/// volumes, as many dimensions as what it is applied to has (of a point: volumes); with a graph,
/// times the share of what may stand inside it, the dominant eigenvector of these factors between
/// the follow sets of a component. No less than a thousandth of the largest beside it, so that no
/// map is starved. Precondition: the system contracts.
[[nodiscard]] std::vector<double> default_weights(const Rifs& rifs);

/// The same, with the factors to the power at which words of any length add up to as much: for
/// similitudes Hausdorff's measure in the similarity dimension (Eq. 5.19). Flat maps
/// have the floor of default_weights().
[[nodiscard]] std::vector<double> natural_weights(const Rifs& rifs);

}  // namespace pxm::host
