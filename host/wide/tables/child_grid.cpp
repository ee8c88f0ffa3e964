#include "host/wide/tables/child_grid.hpp"

#include <algorithm>
#include <cmath>

#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

namespace {

constexpr double rounding = 1e-6;

/// The different values of a row, in order; more than most_slices of them if they are no slices.
std::vector<double> values_of(const HomothetyTable& children, int row) {
    const double* numbers = children.f64.row(row);
    std::vector<double> values(numbers, numbers + children.count);
    std::ranges::sort(values);
    const auto close = [](double a, double b) { return b - a <= rounding; };
    // Not of std::ranges: clang-14 does not know the ranges that g++ 12's library returns.
    values.erase(std::unique(values.begin(), values.end(), close), values.end());
    return values;
}

/// The slice that a centre is in.
int slice_of(const std::vector<double>& centers, double center) {
    const auto found = std::ranges::lower_bound(centers, center - rounding);
    return static_cast<int>(found - centers.begin());
}

}  // namespace

ChildGrid find_grid(const HomothetyTable& children) {
    const std::vector<double> sizes = values_of(children, HomothetyTable::scale);
    if (sizes.size() != 1) return {};
    ChildGrid grid;
    std::array<std::vector<double>, 3> centers;
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        centers[at] = values_of(children, HomothetyTable::center + axis);
        if (centers[at].size() > ChildGrid::most_slices) return {};
        grid.slices[at] = static_cast<int>(centers[at].size());
        grid.planes[at][0] = -1;
        for (std::size_t i = 1; i < centers[at].size(); ++i) {
            const double apart = centers[at][i] - centers[at][i - 1];
            if (apart < 2 * sizes[0] - rounding) return {};
            grid.planes[at][i] = static_cast<float>((centers[at][i] + centers[at][i - 1]) / 2);
        }
        grid.planes[at][centers[at].size()] = 1;
    }
    const int places = grid.slices[0] * grid.slices[1] * grid.slices[2];
    grid.lanes.assign(static_cast<std::size_t>(places), std::int16_t{-1});
    for (int lane = 0; lane < children.count; ++lane) {
        int slice[3];
        for (int axis = 0; axis < 3; ++axis) {
            slice[axis] = slice_of(centers[static_cast<std::size_t>(axis)],
                                   children.f64.row(HomothetyTable::center + axis)[lane]);
        }
        if (grid.lane_at(slice) >= 0) return {};  // two children in one place
        grid.lanes[static_cast<std::size_t>(
            (slice[2] * grid.slices[1] + slice[1]) * grid.slices[0] + slice[0])] =
            static_cast<std::int16_t>(lane);
    }
    return grid;
}

}  // namespace pxm::host::wide
