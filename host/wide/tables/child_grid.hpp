// Children in slices: the boxes of a cell's children are of one size, and along each axis their
// centres take few values, as far apart as the boxes are wide or farther. Menger's sponge has three
// slices along each axis; printed to three digits it has gaps between them, and is a grid still.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace pxm::host::wide {

struct HomothetyTable;

/// Where the children are, and the planes between their slices, in unit coordinates of the cell.
struct ChildGrid {
    static constexpr int most_slices = 8;

    std::array<int, 3> slices{};  // along each axis; 0: the children are in no grid
    std::array<std::array<float, most_slices + 1>, 3> planes{};
    std::vector<std::int16_t> lanes;  // of the child in each slice of x, y, z, x first; -1: none

    [[nodiscard]] bool empty() const { return slices[0] == 0; }
    [[nodiscard]] float plane(int axis, int i) const {
        return planes[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)];
    }
    [[nodiscard]] int lane_at(const int* slice) const {
        return lanes[static_cast<std::size_t>((slice[2] * slices[1] + slice[1]) * slices[0] +
                                              slice[0])];
    }
};

/// The grid of a cell's children, all boxes of one shape; an empty one if they are in none.
[[nodiscard]] ChildGrid find_grid(const HomothetyTable& children);

}  // namespace pxm::host::wide
