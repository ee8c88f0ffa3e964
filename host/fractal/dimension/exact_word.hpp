// Whether two words of maps are the same map, in the scene's very numbers. Products of doubles are
// no doubles as a rule; where they are, and sums as well, equality is more than a measurement.
#pragma once

#include <optional>
#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// The map of a word, outermost map first, if double holds every product and sum on the way to it
/// without rounding. Precondition: the word is not empty.
[[nodiscard]] std::optional<Affine> exact_word(const Rifs& rifs, const std::vector<int>& word);

/// True if both words are known to be the same map, exactly, and the same may stand inside them.
[[nodiscard]] bool are_exactly_one_map(const Rifs& rifs, const std::vector<int>& a,
                                       const std::vector<int>& b);

}  // namespace pxm::host
