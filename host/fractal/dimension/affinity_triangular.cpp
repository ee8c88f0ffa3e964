// The affinity dimension of simultaneously triangular systems, from the diagonals alone [FM07].
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "host/fractal/dimension/affinity.hpp"
#include "host/fractal/system/word_sums.hpp"

namespace pxm::host {

namespace {

constexpr double vanishing = 1e-13;  // of a map's largest entry: rounding of a zero

using Diagonal = std::array<double, 3>;
using Order = std::array<int, 3>;

constexpr std::array<Order, 6> orders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

double largest_entry(const Affine& map) {
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(map.linear[i][j]));
    }
    return largest;
}

/// Upper triangular once the axes are taken in that order; lower ones are so in the reverse order.
bool is_triangular(const Affine& map, const Order& order) {
    const double zero = vanishing * largest_entry(map);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < i; ++j) {
            if (std::abs(map.linear[order[i]][order[j]]) > zero) return false;
        }
    }
    return true;
}

bool is_diagonal(const Affine& map) {
    return is_triangular(map, {0, 1, 2}) && is_triangular(map, {2, 1, 0});
}

Diagonal diagonal(const Affine& map) {
    return {std::abs(map.linear[0][0]), std::abs(map.linear[1][1]), std::abs(map.linear[2][2])};
}

/// Which way `axis` and the plane of the other two depend on each other.
enum class Coupling { axis_on_plane, plane_on_axis };

bool is_conformal_beside(const Affine& map, int axis, Coupling coupling) {
    const double zero = vanishing * largest_entry(map);
    const int b = (axis + 1) % 3;
    const int c = (axis + 2) % 3;
    const glm::dmat3& t = map.linear;
    const auto none = [zero](double x, double y) {
        return std::abs(x) <= zero && std::abs(y) <= zero;
    };
    const bool decoupled = coupling == Coupling::axis_on_plane ? none(t[axis][b], t[axis][c])
                                                               : none(t[b][axis], t[c][axis]);
    const bool turn = none(t[b][b] - t[c][c], t[b][c] + t[c][b]);
    const bool mirror = none(t[b][b] + t[c][c], t[b][c] - t[c][b]);
    return decoupled && (turn || mirror);
}

/// Its blocks' factors along the axes: the plane's factor twice.
Diagonal conformal_factors(const Affine& map, int axis) {
    const int b = (axis + 1) % 3;
    const int c = (axis + 2) % 3;
    Diagonal factors{};
    factors[axis] = std::abs(map.linear[axis][axis]);
    factors[b] = factors[c] = std::hypot(map.linear[b][b], map.linear[b][c]);
    return factors;
}

/// The largest over the orders of the axes of the d at which sum |t_1| |t_2|^{d-1}, or as many
/// factors as d asks for, grows no more.
Interval largest_exponent_of(const Rifs& rifs, int n, const std::vector<Diagonal>& factors) {
    if (!branches(rifs)) return {0, 0};
    const auto components = cyclic_components(rifs);
    std::vector<double> weight(factors.size());
    Interval result{0, 0};
    for (const Order& order : orders) {
        const Interval found = critical_exponent([&](double d) {
            for (std::size_t m = 0; m < weight.size(); ++m) {
                LogStretch stretch{};
                double log = 0;
                for (int i = 0; i < 3; ++i) stretch[i] = log += std::log(factors[m][order[i]]);
                weight[m] = std::exp(log_singular_value_function(stretch, d, n));
            }
            return growth(map_sums(rifs, weight), components);
        });
        result.low = std::max(result.low, found.low);
        result.high = std::max(result.high, found.high);
    }
    return result;
}

template <class Property>
bool all_maps(const Rifs& rifs, const Property& property) {
    return std::all_of(rifs.maps.begin(), rifs.maps.end(), property);
}

ClosedForm closed_form(const Rifs& rifs, int n, const std::vector<Diagonal>& factors,
                       const char* why) {
    return {largest_exponent_of(rifs, n, factors), why};
}

}  // namespace

std::optional<ClosedForm> affinity_of_triangular(const Rifs& rifs, int n) {
    std::vector<Diagonal> factors;
    for (const Order& order : orders) {
        if (!all_maps(rifs, [&](const Affine& map) { return is_triangular(map, order); })) continue;
        for (const Affine& map : rifs.maps) factors.push_back(diagonal(map));
        return closed_form(rifs, n, factors,
                           all_maps(rifs, is_diagonal)
                               ? "exact: all maps are diagonal"
                               : "exact: all maps are triangular in one order of the axes");
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const Coupling coupling : {Coupling::axis_on_plane, Coupling::plane_on_axis}) {
            if (!all_maps(rifs, [&](const Affine& map) {
                    return is_conformal_beside(map, axis, coupling);
                })) {
                continue;
            }
            for (const Affine& map : rifs.maps) factors.push_back(conformal_factors(map, axis));
            return closed_form(rifs, n, factors,
                               "exact: all maps are similitudes of one plane of two axes, and "
                               "triangular beside it");
        }
    }
    return std::nullopt;
}

}  // namespace pxm::host
