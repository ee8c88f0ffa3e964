#include "host/fractal/neighbours/tile_volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "host/fractal/neighbours/convex_tile.hpp"
#include "host/fractal/neighbours/crystal_group.hpp"

namespace pxm::host {

namespace {

using exact::Polynomial;

constexpr double margin = 1e-6;         // of sizes, for rounding
constexpr std::size_t most_types = 60;  // the lattice's minors are their third power
constexpr std::size_t most_cells = 400'000;

/// The linear part is the identity.
bool is_translation(const exact::ExactSystem& system, const exact::ExactMap& map) {
    const int n = system.field.dimensions;
    for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c)
            if (!(map.entry(system.field, r, c) == Polynomial(r == c ? 1 : 0))) return false;
    return true;
}

using Vector = std::vector<Polynomial>;

/// The volume of a cell of the lattice that the vectors generate: their minors are whole multiples
/// of it, without a common factor. Nothing if they generate no lattice.
std::optional<double> lattice_cell(const exact::ExactSystem& system,
                                   const std::vector<Vector>& vectors) {
    const auto n = static_cast<std::size_t>(system.field.dimensions);
    std::vector<Polynomial> minors;
    const std::size_t all = vectors.size();
    for (std::size_t i = 0; i < all; ++i) {
        if (n == 1) minors.push_back(vectors[i][0]);
        for (std::size_t j = i + 1; n > 1 && j < all; ++j) {
            if (n == 2) minors.push_back(exact::determinant(system, {vectors[i], vectors[j]}));
            for (std::size_t k = j + 1; n > 2 && k < all; ++k)
                minors.push_back(exact::determinant(system, {vectors[i], vectors[j], vectors[k]}));
        }
    }
    return exact::common_measure(system, minors);
}

/// Places of a grid that a box of a cell touches, counted; each stands for its volume.
double volume_above(const exact::ExactSystem& system, const Rifs& rifs, const Bounds& bounds) {
    constexpr std::array<double, 3> boxes_a_side{4'096, 512, 64};
    const int n = system.field.dimensions;
    double side = 0;
    for (int i = 0; i < n; ++i) {
        const int axis = system.axes[static_cast<std::size_t>(i)];
        side = std::max(side, bounds.box.high[axis] - bounds.box.low[axis]);
    }
    side *= (1 + margin) / boxes_a_side[static_cast<std::size_t>(n - 1)];
    std::vector<Affine> cells{Affine{}};
    std::set<std::array<long, 3>> places;
    std::size_t looked = 0;
    while (!cells.empty()) {
        const Affine cell = cells.back();
        cells.pop_back();
        glm::dvec3 half{0.0};  // of the box around the image of the bounding box
        const glm::dvec3 center = cell.point((bounds.box.low + bounds.box.high) / 2.0);
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                half[i] +=
                    std::abs(cell.linear[k][i]) * (bounds.box.high[k] - bounds.box.low[k]) / 2;
        double widest = 0;
        for (int i = 0; i < n; ++i)
            widest = std::max(widest, half[system.axes[static_cast<std::size_t>(i)]]);
        if (2 * widest > side) {
            if (++looked > most_cells) return INFINITY;
            for (const Affine& map : rifs.maps) cells.push_back(then(map, cell));
            continue;
        }
        std::array<long, 3> low{}, high{};
        for (int i = 0; i < n; ++i) {
            const auto a = static_cast<std::size_t>(i);
            const int axis = system.axes[a];
            low[a] = std::lround(std::floor((center[axis] - half[axis]) / side - margin));
            high[a] = std::lround(std::floor((center[axis] + half[axis]) / side + margin));
        }
        for (long x = low[0]; x <= high[0]; ++x)
            for (long y = low[1]; y <= high[1]; ++y)
                for (long z = low[2]; z <= high[2]; ++z) places.insert({x, y, z});
    }
    return static_cast<double>(places.size()) * std::pow(side, n);
}

/// What the volume is a whole multiple of, by the lattice of the neighbours.
Decided<double> lattice_unit(const exact::ExactSystem& system, const NeighbourGraph& graph) {
    std::vector<Vector> translations;
    for (const NeighbourType& type : graph.types) {
        if (!type.touches) continue;
        if (!is_translation(system, type.map))
            return {std::nullopt, "not all neighbours are translated copies"};
        Vector& v = translations.emplace_back();
        for (int i = 0; i < system.field.dimensions; ++i)
            v.push_back(type.map.entry(system.field, i, system.field.dimensions));
    }
    if (translations.size() > most_types) return {std::nullopt, "too many neighbours"};
    const auto cell = lattice_cell(system, translations);
    if (!cell) return {std::nullopt, "the neighbours' translations are no lattice"};
    return {cell, "a cell of the lattice by which its copies tile [LW96]"};
}

Decided<double> unit_of(const exact::ExactSystem& system, const Rifs& rifs,
                        const NeighbourGraph& graph, bool connected) {
    if (rifs.follow_sets.size() > 1) return {std::nullopt, "there is no formula for graphs"};
    Decided<double> unit = lattice_unit(system, graph);
    if (unit.value || !connected) return unit;
    Decided<double> of_group = crystal_cell(system, graph);
    return of_group.value ? of_group
                          : Decided<double>{std::nullopt, unit.why + "; " + of_group.why};
}

}  // namespace

TileVolume tile_volume(const exact::ExactSystem& system, const Rifs& rifs,
                       const NeighbourGraph& graph, const std::vector<Bounds>& bounds,
                       bool connected) {
    if (system.field.dimensions < 3 && !exact::is_coordinate_plane(system))
        return {{std::nullopt, "not computed: it lies aslant"}, std::nullopt};
    if (rifs.follow_sets.size() == 1)
        if (const auto convex = convex_volume(system))
            return {{convex, "a convex body, which the maps' images of it fill [Hutchinson81]"},
                    {}};
    const Decided<double> unit = unit_of(system, rifs, graph, connected);
    const double above = unit.value ? volume_above(system, rifs, bounds[0]) : INFINITY;
    if (unit.value && above < 2 * *unit.value) return {{unit.value, "that of " + unit.why}, {}};
    auto between = volume_bracket(system, rifs, graph, bounds);
    if (!between) return {{std::nullopt, "not computed: " + unit.why}, {}};
    between->high = std::min(between->high, above);
    if (!unit.value)
        return {{std::nullopt, fmt::format("between {:.6g} and {:.6g}: {}", between->low,
                                           between->high, unit.why)},
                between};
    const double least = std::max(1.0, std::ceil(between->low / *unit.value * (1 - margin)));
    const double most = std::floor(between->high / *unit.value * (1 + margin));
    if (least != most)
        return {{std::nullopt, fmt::format("{:g} to {:g} times that of {}", least, most, unit.why)},
                between};
    return {
        {least * *unit.value, fmt::format("{:g} times that of {}, as it lies between {:.6g} and "
                                          "{:.6g}",
                                          least, unit.why, between->low, between->high)},
        between};
}

}  // namespace pxm::host
