// The collage of a set in the plane: how far it is from the union of its images, and by Theorem 8.1
// how far from the attractor.
#pragma once

#include <span>
#include <vector>

#include "host/import/moments/moments.hpp"

namespace pxm::host {

/// A set of points on a square grid, with the distance to it from every cell.
class GridSet {
  public:
    /// The points on a grid with about `cells` cells along the longer side of their box. `finest`
    /// is the smallest cell that makes sense: the distance between neighbours.
    GridSet(std::span<const WeightedPoint> points, int cells, double finest);

    [[nodiscard]] double cell() const { return cell_; }
    /// An upper bound of the Hausdorff distance of the set's cell centres from the union of their
    /// images, too large by at most a cell and a half, or more for images that stick out by more
    /// than a quarter of the set's size.
    [[nodiscard]] double collage_distance(std::span<const PlaneMap> maps) const;

  private:
    [[nodiscard]] std::size_t cell_of(double x, double y) const;  // the nearest one
    [[nodiscard]] double from_center(double x, double y) const;   // of that cell
    [[nodiscard]] WeightedPoint center(std::size_t cell) const;
    /// Distances of all cells from the marked ones.
    [[nodiscard]] std::vector<double> distances(const std::vector<char>& marked) const;

    double low_x_ = 0, low_y_ = 0, cell_ = 1;
    std::size_t columns_ = 1, rows_ = 1;
    std::vector<std::size_t> set_;
    std::vector<double> distance_;  // from the set
};

/// Theorem 8.1 (Eq. 8.1): the attractor is no farther from the set than this. Infinite if the maps
/// do not contract.
[[nodiscard]] double collage_bound(double collage_distance, std::span<const PlaneMap> maps);

}  // namespace pxm::host
