// Figures of the literature in a line of code each, for lists of systems with a known dimension.
#pragma once

#include <cmath>
#include <complex>
#include <glm/vec3.hpp>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/host/fractal/systems.hpp"
#include "tests/support/known_systems.hpp"

namespace pxm::host::systems {

using Complex = std::complex<double>;

inline double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// x -> ratio x, turned and moved, in the plane z = 0.
inline Affine plane_map(double ratio, double turn, Complex move) {
    return map({scaling(glm::dvec3{ratio}), rotation(Axis::z, turn),
                translation({move.real(), move.imag(), 0})});
}

/// A curve in which each edge of a path becomes the path again.
inline Rifs path(const std::vector<Complex>& corners) {
    std::vector<Affine> maps;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const Complex edge = corners[i + 1] - corners[i];
        maps.push_back(plane_map(std::abs(edge), degrees(std::arg(edge)), corners[i]));
    }
    return complete(maps);
}

/// Cells (i, j, k) of a grid of n a side that are kept.
template <class Kept>
Rifs cells_3d(int n, const Kept& kept) {
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            for (int k = 0; k < n; ++k) {
                if (kept(i, j, k)) corners.push_back(glm::dvec3{i, j, k} / double(n));
            }
        }
    }
    return complete(homotheties(1.0 / n, corners));
}

template <class Kept>
Rifs cells(int n, const Kept& kept) {
    return cells_3d(n, [&](int i, int j, int k) { return k == 0 && kept(i, j); });
}

template <class Kept>
Rifs digits(int n, const Kept& kept) {
    return cells(n, [&](int i, int j) { return j == 0 && kept(i); });
}

/// Copies towards the corners, of a figure with its middle at the origin.
inline Rifs towards(double ratio, std::vector<glm::dvec3> corners) {
    for (glm::dvec3& corner : corners) corner *= 1 - ratio;
    return complete(homotheties(ratio, corners));
}

inline std::vector<glm::dvec3> polygon(int corners) {
    std::vector<glm::dvec3> result;
    for (int i = 0; i < corners; ++i) {
        const Complex corner = std::polar(1.0, 2 * std::numbers::pi * i / corners);
        result.push_back({corner.real(), corner.imag(), 0});
    }
    return result;
}

/// The d at which the ratios' powers add up to 1 (Eq. 5.19).
inline double moran(const std::vector<double>& ratios) {
    double low = 0;
    double high = 8;
    for (int n = 0; n < 100; ++n) {
        const double d = (low + high) / 2;
        double sum = 0;
        for (const double ratio : ratios) sum += std::pow(ratio, d);
        (sum > 1 ? low : high) = d;
    }
    return low;
}

/// Rectangles of n columns and m < n rows, all equal: log R/log m + log(N/R)/log n with N kept
/// rectangles in R rows [BM84].
inline KnownSystem carpet(const std::string& name, int n, int m,
                          const std::vector<std::pair<int, int>>& kept) {
    std::vector<Affine> maps;
    std::set<int> rows;
    for (const auto& [column, row] : kept) {
        maps.push_back(map({scaling({1.0 / n, 1.0 / m, 0}),
                            translation({double(column) / n, double(row) / m, 0})}));
        rows.insert(row);
    }
    const double in_rows = static_cast<double>(rows.size());
    const double all = static_cast<double>(kept.size());
    return {name, complete(maps),
            std::log(in_rows) / std::log(m) + std::log(all / in_rows) / std::log(n)};
}

}  // namespace pxm::host::systems
