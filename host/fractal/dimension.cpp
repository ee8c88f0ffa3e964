#include "host/fractal/dimension.hpp"

#include <algorithm>

#include "host/fractal/lipschitz.hpp"
#include "host/fractal/similarity.hpp"

namespace pxm::host {

namespace {

constexpr double generic_constant = 0.5;  // [Solomyak98]; Theorem 6.1 has 1/3

/// Theorem 5.4 for similitudes with the open-set condition; Theorem 6.1 for almost all
/// translations.
std::string meaning_of(const Rifs& rifs, const Dimensions& found, OpenSetCondition condition) {
    if (found.similarity && condition == OpenSetCondition::holds) {
        return "the Hausdorff and box-counting dimensions are the similarity dimension: "
               "similitudes "
               "with the open-set condition (Theorem 5.4)";
    }
    if (found.similarity && condition == OpenSetCondition::fails) {
        return "the Hausdorff dimension is at most the similarity dimension, and may be less: the "
               "open-set condition fails";
    }
    const bool generic = std::ranges::all_of(
        rifs.maps, [](const Affine& map) { return lipschitz_constant(map) < generic_constant; });
    if (generic) {
        return "the Hausdorff and box-counting dimensions are at most the affinity dimension, and "
               "equal to it (or to 3) for almost all translations: all Lipschitz constants are "
               "below 1/2 (Theorem 6.1)";
    }
    return "the Hausdorff dimension is at most the affinity dimension";
}

}  // namespace

Dimensions dimensions(const Rifs& rifs, const std::vector<Bounds>& bounds,
                      OpenSetCondition condition) {
    Dimensions found;
    found.similarity = similarity_dimension(rifs);
    found.affinity = affinity_dimension(rifs);
    found.box_counting = count_boxes(rifs, bounds);
    found.meaning = meaning_of(rifs, found, condition);
    return found;
}

}  // namespace pxm::host
