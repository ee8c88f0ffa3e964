// The support functions of all E_s in many directions at once, from above: where contraction is
// slow and turns, a descent meets too many cells, but h_s(u) = max h_t(u T_m^T) + u . a_m can be
// iterated on a grid (thesis-notes, "After the thesis"; the polytopes of Lawlor and Hart 2003). The
// grid lies on the octahedron |x|+|y|+|z| = n, in triangles. h is convex and homogeneous, so
// between grid points it is at most the sum of their values: what is interpolated is a bound.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "host/fractal/system/rifs.hpp"
#include "host/math/rounding.hpp"

namespace pxm::host {

/// A triangulation of the directions.
class DirectionGrid {
  public:
    DirectionGrid() = default;
    explicit DirectionGrid(int steps);  // an octahedron with so many steps along an edge

    [[nodiscard]] int steps() const { return steps_; }  // along an edge

    /// u = sum of weight[i] * point(corner[i]), all weights at least 0.
    struct Place {
        std::array<int, 3> corner;     // grid points
        std::array<double, 3> weight;  // of each
    };
    /// Precondition: u is not zero.
    [[nodiscard]] Place locate(const glm::dvec3& u) const;

    /// Places of the index, some of which stand for no direction.
    [[nodiscard]] int size() const { return static_cast<int>(points_.size()); }
    /// Grid point i, no unit vector.
    [[nodiscard]] const glm::dvec3& point(int i) const { return points_[i]; }
    /// False for a place of the index that stands for no direction.
    [[nodiscard]] bool is_point(int i) const { return points_[i] != glm::dvec3{0.0}; }
    /// If h(u) <= |u| at all grid points u, what is interpolated is at most this times |u|
    /// anywhere.
    [[nodiscard]] double bulge() const;

  private:
    [[nodiscard]] int index(int x, int y, int sign_z) const;

    int steps_ = 0;
    std::vector<glm::dvec3> points_;  // upper half by x and y, then the lower half
};

/// Upper bounds of h_s on a grid, measured from a centre of each set. Beside each value stands what
/// it may be short by for rounding.
class SupportGrid {
  public:
    SupportGrid() = default;
    /// `extents`: no point of E_s is farther from its centre along any axis.
    SupportGrid(int steps, std::vector<glm::dvec3> centers, std::vector<double> extents);

    [[nodiscard]] bool empty() const { return value_.empty(); }  // nothing is known yet
    /// An upper bound of h_set(u), up to its rounding.
    [[nodiscard]] double support(int set, const glm::dvec3& u) const;
    /// What support() may be short by.
    [[nodiscard]] double rounding(int set, const glm::dvec3& u) const;

    [[nodiscard]] const DirectionGrid& directions() const { return directions_; }  // of the grid
    /// From which h_set is measured.
    [[nodiscard]] const glm::dvec3& center(int set) const { return center_[set]; }
    /// h_set - u . center at grid point i.
    [[nodiscard]] const Rounded& value(int set, int i) const { return value_[set][i]; }
    /// Puts a value in.
    void set_value(int set, int i, const Rounded& value) { value_[set][i] = value; }

    /// One round of h_s(u) = max h_t(u T_m^T) + u . a_m over all sets and directions, never upward.
    /// Returns the largest change as a share of the largest value of its set.
    double iterate(const Rifs& rifs);

    /// The map of the set that reaches farthest in direction u, by what the grid tells.
    [[nodiscard]] int best_map(const Rifs& rifs, int set, const glm::dvec3& u) const;

  private:
    [[nodiscard]] double reach_of_map(const Rifs& rifs, int map, const glm::dvec3& u) const;
    [[nodiscard]] double rounding_of_map(const Rifs& rifs, int map, const glm::dvec3& u) const;
    [[nodiscard]] double from_center(int set, const glm::dvec3& u) const;
    [[nodiscard]] double rounding_from_center(int set, const glm::dvec3& u) const;

    DirectionGrid directions_;
    std::vector<glm::dvec3> center_;
    std::vector<double> extent_;
    std::vector<std::vector<Rounded>> value_;  // by set, then grid point
};

}  // namespace pxm::host
