// The measured dimension and its error, against systems whose dimension is known.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "host/fractal/dimension/box_counting.hpp"
#include "host/fractal/system/contraction.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "tests/support/held_out_systems.hpp"
#include "tests/support/known_systems.hpp"

namespace pxm::host {
namespace {

struct Tried {
    int measured = 0;
    int beyond = 0;  // two errors
    double too_low = 0;
};

Tried try_all(const std::vector<systems::KnownSystem>& list) {
    Tried tried;
    for (const systems::KnownSystem& known : list) {
        const Rifs rifs = reachable_part(known.rifs);
        const BoxCounting found = count_boxes(rifs, bound(rifs, prove_contraction(rifs)));
        if (!found.dimension) continue;
        ++tried.measured;
        const double off = *found.dimension - known.dimension;
        tried.too_low -= off;
        if (std::abs(off) <= 2 * found.error) continue;
        ++tried.beyond;
        std::cout << known.name << ": " << *found.dimension << " +- " << found.error << ", not "
                  << known.dimension << '\n';
    }
    return tried;
}

TEST(BoxCountingSlow, of_20_systems_19_are_within_two_errors) {
    const Tried tried = try_all(systems::known_systems());
    EXPECT_GE(tried.measured, 50);
    EXPECT_LE(20 * tried.beyond, tried.measured);
    EXPECT_LT(std::abs(tried.too_low), 0.015 * tried.measured);
}

TEST(BoxCountingSlow, so_are_19_of_20_that_it_was_not_made_with) {
    const Tried tried = try_all(systems::held_out_systems());
    EXPECT_GE(tried.measured, 80);
    EXPECT_LE(20 * tried.beyond, tried.measured);
    EXPECT_LT(std::abs(tried.too_low), 0.015 * tried.measured);
}

}  // namespace
}  // namespace pxm::host
