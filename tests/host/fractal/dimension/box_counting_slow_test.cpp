// The measured dimension and its error, against systems whose dimension is known.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "host/fractal/dimension/box_counting.hpp"
#include "host/fractal/system/contraction.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "tests/support/known_systems.hpp"

namespace pxm::host {
namespace {

TEST(BoxCountingSlow, of_20_systems_19_are_within_two_errors) {
    int measured = 0;
    int beyond = 0;
    double too_low = 0;
    for (const systems::KnownSystem& known : systems::known_systems()) {
        const Rifs rifs = reachable_part(known.rifs);
        const BoxCounting found = count_boxes(rifs, bound(rifs, prove_contraction(rifs)));
        if (!found.dimension) continue;
        ++measured;
        const double off = *found.dimension - known.dimension;
        too_low -= off;
        if (std::abs(off) <= 2 * found.error) continue;
        ++beyond;
        std::cout << known.name << ": " << *found.dimension << " +- " << found.error << ", not "
                  << known.dimension << '\n';
    }
    EXPECT_GE(measured, 50);
    EXPECT_LE(20 * beyond, measured);
    EXPECT_LT(std::abs(too_low), 0.015 * measured);
}

}  // namespace
}  // namespace pxm::host
