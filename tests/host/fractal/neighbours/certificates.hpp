// What exact numbers decide of systems of whole numbers, against counting.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "tests/host/fractal/neighbours/whole_systems.hpp"

namespace pxm::test {

struct Certified {
    int holds = 0;
    int fails = 0;
    int inside = 0;
    int open = 0;
};

/// Boxes around all cells of a level, counted as unit cubes of whole numbers, have no less volume
/// than the whole. Where the maps' volumes add up to the whole's, and that is not 0, no two cells
/// of a level share any: together they have what the whole has.
inline void expect_volumes(const WholeTurningSystem& system, const host::ExactFindings& found,
                           int levels) {
    const double base = static_cast<double>(system.base);
    const auto cells = system.level(levels);
    // All of the attractor lies within [-4, 4] times 1 / (base - 1) of the origin.
    const auto reach = static_cast<long>(std::ceil(4.0 / (base - 1)));
    std::set<std::array<long, 3>> boxes;
    for (const WholeMap& cell : cells)
        for (long x = -reach; x < reach; ++x)
            for (long y = -reach; y < reach; ++y)
                for (long z = system.dimensions == 3 ? -reach : 0;
                     z < (system.dimensions == 3 ? reach : 1); ++z)
                    boxes.insert({cell.offset[0] + x, cell.offset[1] + y, cell.offset[2] + z});
    const double above =
        static_cast<double>(boxes.size()) / std::pow(base, levels * system.dimensions);
    if (found.volume.value) {
        EXPECT_LE(*found.volume.value, above * (1 + 1e-9)) << system.text();
    } else if (found.volume_between) {
        EXPECT_LE(found.volume_between->low, above * (1 + 1e-9)) << system.text();
    }
}

inline void expect_certificate(const WholeTurningSystem& system, int levels, Certified& sums) {
    const host::ExactFindings found = exact_of(system.text(), {.types = 400, .steps = 400'000});
    if (found.overlaps.value.value_or(false)) {
        const auto& [u, v] = found.overlapping_words;
        EXPECT_NE(u, v);
        EXPECT_EQ(u.size(), v.size());
        EXPECT_TRUE(system.word(u) == system.word(v)) << system.text();
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
