#include "host/fractal/dimension/dimension.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/fractal/bounds/affine_hull.hpp"
#include "host/fractal/dimension/similarity.hpp"
#include "host/math/lipschitz.hpp"
#include "host/text/six_digits.hpp"

namespace pxm::host {

namespace {

constexpr double generic_constant = 0.5;  // [Solomyak98]; Theorem 6.1 has 1/3

/// Theorem 6.1, for almost all translations.
bool is_generic(const Rifs& rifs) {
    return std::ranges::all_of(rifs.maps, [](const Affine& map) {
        return lipschitz_constant(map) < generic_constant * (1 - scene_error);
    });
}

std::string bound_and_why(const Dimensions& found) {
    if (found.upper < found.affinity.upper) {
        return found.upper == 3 ? "at most 3"
                                : fmt::format("at most {}: the attractor lies in a {}", found.upper,
                                              hull_name(int(found.upper)));
    }
    return found.affinity.exact ? "at most the affinity dimension"
                                : fmt::format("at most {}", six_digits_above(found.upper));
}

/// Theorem 5.4 for similitudes with the open-set condition.
std::string meaning_of(const Rifs& rifs, const Dimensions& found, OpenSetCondition condition) {
    if (found.exact && *found.exact == 0) {
        return "the Hausdorff and box-counting dimensions are 0: the attractor is made of single "
               "points";
    }
    if (found.exact) {
        return found.similarity
                   ? "the Hausdorff and box-counting dimensions are the similarity dimension: "
                     "similitudes with the open-set condition (Theorem 5.4)"
                   : "the Hausdorff and box-counting dimensions are the affinity dimension: "
                     "similitudes in other coordinates with the open-set condition (Theorem 5.4)";
    }
    const std::string bound = bound_and_why(found);
    if (found.similarity && condition == OpenSetCondition::fails) {
        return "the Hausdorff dimension is " + bound +
               "; it may be less, as the open-set condition fails";
    }
    if (is_generic(rifs)) {
        return fmt::format(
            "the Hausdorff and box-counting dimensions are {}, and equal to the affinity dimension "
            "(or to {}) for almost all translations: all Lipschitz constants are below 1/2 "
            "(Theorem 6.1)",
            bound, found.hull);
    }
    return "the Hausdorff and box-counting dimensions are " + bound;
}

}  // namespace

Dimensions dimensions(const Rifs& rifs, OpenSetCondition condition) {
    Dimensions found;
    found.similarity = similarity_dimension(rifs);
    found.affinity = affinity_dimension(rifs);
    const std::vector<AffineHull> hulls = affine_hulls(rifs);
    found.hull = hulls[rifs.start].dimension;
    found.upper = std::min<double>(recurrent_dimension(rifs, hulls), found.affinity.upper);
    const bool conformal = found.similarity || found.affinity.conformal;
    if (found.upper == 0) {
        found.exact = 0;
    } else if (conformal && found.affinity.exact && condition == OpenSetCondition::holds) {
        found.exact = std::min(found.affinity.value, found.upper);
    }
    found.meaning = meaning_of(rifs, found, condition);
    return found;
}

void add_topology(Dimensions& found, const std::optional<bool>& totally_disconnected) {
    constexpr double rounding = 1e-9;
    if (found.exact || totally_disconnected != false || found.upper > 1 + rounding) return;
    found.exact = 1;
    found.meaning =
        "the Hausdorff and box-counting dimensions are 1: no more, and a piece of it is "
        "connected";
}

}  // namespace pxm::host
