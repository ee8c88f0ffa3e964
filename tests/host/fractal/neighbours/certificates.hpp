// What exact numbers decide of systems of whole numbers, against counting.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <vector>

#include "tests/host/fractal/neighbours/whole_systems.hpp"

namespace pxm::test {

struct Certified {
    int holds = 0;
    int fails = 0;
    int inside = 0;
    int open = 0;
};

/// Boxes around all cells of a level, counted as unit cubes of whole numbers in the coordinates of
/// what the attractor spans, have no less volume than the whole. Where the maps' volumes add up to
/// the whole's, and that is not 0, no two cells of a level share any: together they have what the
/// whole has.
inline void expect_volumes(const WholeTurningSystem& system, const host::ExactFindings& found,
                           int levels) {
    const double base = static_cast<double>(system.base);
    const auto cells = system.level(levels);
    // All of the attractor lies within [-4, 4] times 1 / (base - 1) of the origin.
    const auto reach = static_cast<long>(std::ceil(4.0 / (base - 1)));
    std::array<std::array<long, 2>, 3> span{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axes = found.axes.begin();
        const bool counts = std::find(axes, axes + found.dimensions, static_cast<int>(i)) !=
                            axes + found.dimensions;
        span[i] = counts ? std::array<long, 2>{-reach, reach} : std::array<long, 2>{0, 1};
    }
    std::set<std::array<long, 3>> boxes;
    for (const WholeMap& cell : cells)
        for (long x = span[0][0]; x < span[0][1]; ++x)
            for (long y = span[1][0]; y < span[1][1]; ++y)
                for (long z = span[2][0]; z < span[2][1]; ++z)
                    boxes.insert({span[0][0] < 0 ? cell.offset[0] + x : 0,
                                  span[1][0] < 0 ? cell.offset[1] + y : 0,
                                  span[2][0] < 0 ? cell.offset[2] + z : 0});
    const double above =
        static_cast<double>(boxes.size()) / std::pow(base, levels * found.dimensions);
    if (found.volume.value) {
        EXPECT_LE(*found.volume.value, above * (1 + 1e-9)) << system.text();
    } else if (found.volume_between) {
        EXPECT_LE(found.volume_between->low, above * (1 + 1e-9)) << system.text();
    }
}

/// Whether two words of one length do the same to the attractor: to where maps stand still, and to
/// the maps' images of these. Such a place is where a word of many equal maps takes 0, nearly; in
/// units that become smaller by the base with each map, what is different is soon far apart.
inline bool same_on_attractor(const WholeTurningSystem& system, const std::vector<int>& u,
                              const std::vector<int>& v) {
    constexpr int equal_maps = 12;
    constexpr long near = 64;  // units: less than the base's power, more than 0 is off the place
    const auto count = static_cast<int>(system.maps.size());
    for (int first = -1; first < count; ++first)
        for (int m = 0; m < count; ++m) {
            std::vector<int> end(equal_maps, m);
            if (first >= 0) end.insert(end.begin(), first);
            std::vector<int> one = u, other = v;
            one.insert(one.end(), end.begin(), end.end());
            other.insert(other.end(), end.begin(), end.end());
            const WholeMap a = system.word(one), b = system.word(other);
            for (std::size_t i = 0; i < 3; ++i)
                if (std::abs(a.offset[i] - b.offset[i]) > near) return false;
        }
    return true;
}

inline void expect_certificate(const WholeTurningSystem& system, int levels, Certified& sums) {
    const host::ExactFindings found = exact_of(system.text(), {.types = 400, .steps = 400'000});
    if (found.overlaps.value.value_or(false)) {
        const auto& [u, v] = found.overlapping_words;
        EXPECT_NE(u, v);
        EXPECT_EQ(u.size(), v.size());
        // On a line, a reflection at it is the identity.
        EXPECT_TRUE(found.dimensions < system.dimensions ? same_on_attractor(system, u, v)
                                                         : system.word(u) == system.word(v))
            << system.text();
    }
    if (!found.open_set.value) {
        ++sums.open;
        return;
    }
    const double all = std::pow(static_cast<double>(system.maps.size()), levels);
    if (*found.open_set.value) {
        ++sums.holds;
        EXPECT_EQ(static_cast<double>(system.level(levels).size()), all) << system.text();
    } else {
        ++sums.fails;
    }
    if (found.interior.value.value_or(false)) {
        ++sums.inside;
        expect_volumes(system, found, levels);
    }
}

}  // namespace pxm::test
