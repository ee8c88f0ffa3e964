#include "host/wide/tables/common_grid.hpp"

#include <algorithm>
#include <cmath>

#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

namespace {

constexpr float nowhere = 2;  // centres lie in the cell, between -1 and 1

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A set and all that follow it.
std::vector<int> sets_from(std::span<const WideSet> sets, int first) {
    std::vector<int> found{first};
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (const int next : sets[at(found[i])].sets) {
            if (std::ranges::find(found, next) == found.end()) found.push_back(next);
        }
    }
    return found;
}

/// The slices that a place is in, x first.
std::array<int, 3> slices_at(const CommonGrid& grid, int place) {
    const auto& n = grid.slices;
    return {place % n[0], place / n[0] % n[1], place / n[0] / n[1]};
}

/// Whether two numbers may be taken for one. The boxes of a graph are bounded to within less, and a
/// float that is not near 0 does not show it.
bool same(float a, float b) { return std::abs(a - b) <= 1e-9F; }

/// Notes where a set's children are along each axis, and how large. False if that is not what other
/// children of the object say.
bool agree(const WideSet& set, bool is_first, CommonGrid& grid) {
    const HomothetyTable& table = set.children;
    if (is_first) {
        grid.slices = set.grid.slices;
        grid.planes = set.grid.planes;
        for (auto& axis : grid.centers) axis.fill(nowhere);
        grid.scale = table.rows.row(HomothetyTable::scale)[0];
        grid.constant = table.rows.row(HomothetyTable::constant)[0];
        grid.diameter = table.rows.row(HomothetyTable::diameter)[0];
    }
    if (set.grid.slices != grid.slices) return false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!std::ranges::equal(set.grid.planes[axis], grid.planes[axis], same)) return false;
    }
    const int places = grid.slices[0] * grid.slices[1] * grid.slices[2];
    for (int place = 0; place < places; ++place) {
        const std::array<int, 3> slice = slices_at(grid, place);
        const int lane = set.grid.lane_at(slice.data());
        if (lane < 0) continue;
        if (table.rows.row(HomothetyTable::scale)[lane] != grid.scale ||
            table.rows.row(HomothetyTable::constant)[lane] != grid.constant ||
            table.rows.row(HomothetyTable::diameter)[lane] != grid.diameter) {
            return false;
        }
        for (int axis = 0; axis < 3; ++axis) {
            float& center = grid.centers[at(axis)][at(slice[at(axis)])];
            const float here = table.rows.row(HomothetyTable::center + axis)[lane];
            if (center == nowhere) center = here;
            if (!same(center, here)) return false;
        }
    }
    return true;
}

/// Numbers the places.
void number_places(CommonGrid& grid) {
    const auto& n = grid.slices;
    grid.steps = {1, n[0], n[0] * n[1]};
    for (int place = 0; place < n[0] * n[1] * n[2]; ++place) {
        const std::array<int, 3> slice = slices_at(grid, place);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (int i = 0; i <= slice[axis]; ++i) {
                grid.from_slice[axis][at(i)] |=
                    static_cast<std::int32_t>(std::uint32_t{1} << place);
            }
        }
    }
}

/// Fills in what is at a set's places, as they are numbered in an octant.
void put_places(const WideSet& set, int number, int octant, CommonGrid& grid) {
    const int places = grid.slices[0] * grid.slices[1] * grid.slices[2];
    for (int place = 0; place < places; ++place) {
        std::array<int, 3> slice = slices_at(grid, place);
        for (int axis = 0; axis < 3; ++axis) {
            if ((octant >> axis & 1) == 0) continue;
            slice[at(axis)] = grid.slices[at(axis)] - 1 - slice[at(axis)];
        }
        const int lane = set.grid.lane_at(slice.data());
        if (lane < 0) continue;
        grid.occupied[CommonGrid::row(number, octant)] |= std::uint32_t{1} << place;
        const std::size_t entry = CommonGrid::entry(number, octant, place);
        grid.lanes[entry] = lane;
        grid.next[entry] = grid.number_of(set.sets[at(lane)]);
    }
}

}  // namespace

int CommonGrid::number_of(int set) const {
    return static_cast<int>(std::ranges::find(sets, set) - sets.begin());
}

CommonGrid find_common_grid(std::span<const WideSet> sets, int first) {
    constexpr std::size_t most_sets = 256;
    CommonGrid grid;
    const std::vector<int> found = sets_from(sets, first);
    const std::array<int, 3>& slices = sets[at(first)].grid.slices;
    if (found.size() > most_sets || slices[0] * slices[1] * slices[2] > CommonGrid::most_places) {
        return {};
    }
    for (const int set : found) {
        if (!agree(sets[at(set)], set == first, grid)) return {};
    }
    number_places(grid);
    grid.sets = found;
    grid.occupied.assign(CommonGrid::row(static_cast<int>(found.size()), 0), 0);
    grid.lanes.assign(grid.occupied.size() * CommonGrid::most_places, -1);
    grid.next.assign(grid.lanes.size(), 0);
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (int octant = 0; octant < CommonGrid::octants; ++octant) {
            put_places(sets[at(found[i])], static_cast<int>(i), octant, grid);
        }
    }
    return grid;
}

}  // namespace pxm::host::wide
