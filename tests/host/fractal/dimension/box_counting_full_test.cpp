// Box counting on hundreds of systems that it was not made with, of every kind many.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>

#include "tests/host/fractal/dimension/known_dimensions.hpp"
#include "tests/support/held_out_systems.hpp"

namespace pxm::host {
namespace {

TEST(BoxCountingCampaign,
     the_errors_of_95_percent_of_300_systems_that_it_was_not_made_with_hold_the_dimension) {
    known_dimensions::TriedKinds kinds = known_dimensions::try_kinds(systems::held_out_systems(24));
    for (const auto& [kind, tried] : kinds)
        std::cout << fmt::format("| {} | {} | {} | {} | {:.4f} |\n", kind, tried.systems,
                                 tried.measured, tried.beyond, tried.errors / tried.measured);
    const known_dimensions::Tried& all = kinds[""];
    EXPECT_GE(all.systems, 300);
    known_dimensions::errors_are_right(all);
    RecordProperty("systems", all.systems);
    RecordProperty("measured", all.measured);
    RecordProperty("beyond", all.beyond);
}

}  // namespace
}  // namespace pxm::host
