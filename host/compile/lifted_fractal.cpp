#include "host/compile/lifted_fractal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr double vanishing = 1e-12;  // of the largest singular value, as classify() has it
constexpr double least_lift = 1e-6;  // thinner would cost a float its digits
constexpr double thinner = 1e-2;     // from one try to the next
constexpr double thinnest = 1e-30;
constexpr double most_lift = 1e-2;  // coarser pixels do not make flat images thicker

bool has_singular_maps(const Rifs& rifs) {
    return std::ranges::any_of(
        rifs.maps, [](const Affine& map) { return classify(map) == MapKind::singular; });
}

/// Lifts the singular maps to a share of a set. A strong shear counts as singular too, and what
/// thickness does to it can be large: where the system cannot be shown to contract any more, the
/// share is made smaller. False if none will do; then nothing changes.
bool lift_singular_maps(Fractal& fractal, double share) {
    Rifs lifted = fractal.exact;
    for (; share >= thinnest; share *= thinner) {
        for (std::size_t i = 0; i < lifted.maps.size(); ++i) {
            if (classify(fractal.exact.maps[i]) != MapKind::singular) continue;
            lifted.maps[i] = lift(fractal.exact.maps[i], share);
        }
        Contraction contraction = prove_contraction(lifted);
        if (contraction.proof == ContractionProof::none) continue;
        fractal.rifs = std::move(lifted);
        fractal.contraction = std::move(contraction);
        fractal.lifted = true;
        return true;
    }
    return false;
}

}  // namespace

std::optional<Fractal> make_fractal(const IfsBlock& block, Diagnostics& diagnostics) {
    auto proven = prove_rifs(block, diagnostics);
    if (!proven) return std::nullopt;
    Fractal fractal;
    fractal.rifs = proven->rifs;
    fractal.exact = std::move(proven->rifs);
    fractal.contraction = std::move(proven->contraction);
    if (has_singular_maps(fractal.exact) && !lift_singular_maps(fractal, first_lift)) {
        diagnostics.error(block.position,
                          fmt::format("ifs \"{}\" could not be shown to contract once its singular "
                                      "maps have the thickness that rays need",
                                      block.name));
        return std::nullopt;
    }
    return fractal;
}

void lift_again(Fractal& fractal, double share) {
    if (!lift_singular_maps(fractal, std::clamp(share, least_lift, most_lift))) return;
    fractal.bounds = bound(fractal.rifs, fractal.contraction);
}

std::vector<glm::dvec3> lost_axes(const Affine& map) {
    std::vector<glm::dvec3> axes;
    if (classify(map) != MapKind::singular) return axes;
    const SingularValues values = singular_values(map.linear);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (values.values[axis] <= vanishing * values.values[0]) axes.push_back(values.input[axis]);
    }
    return axes;
}

double squashed_extent(const Fractal& fractal) {
    double smallest = INFINITY;
    for (std::size_t i = 0; i < fractal.exact.maps.size(); ++i) {
        const Bounds& inside = fractal.bounds[static_cast<std::size_t>(fractal.rifs.follow_of[i])];
        const glm::dvec3 size = inside.box.high - inside.box.low;
        for (const glm::dvec3& axis : lost_axes(fractal.exact.maps[i])) {
            const double extent = glm::dot(glm::abs(axis), size);
            if (extent > 1e-6 * inside.ball.radius) smallest = std::min(smallest, extent);
        }
    }
    return smallest;
}

}  // namespace pxm::host
