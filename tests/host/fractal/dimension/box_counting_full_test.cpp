// Box counting on hundreds of systems that it was not made with.
#include <gtest/gtest.h>

#include "tests/host/fractal/dimension/known_dimensions.hpp"
#include "tests/support/held_out_systems.hpp"

namespace pxm::host {
namespace {

TEST(BoxCountingCampaign,
     the_errors_of_95_percent_of_300_systems_that_it_was_not_made_with_hold_the_dimension) {
    const known_dimensions::Tried tried = known_dimensions::try_all(systems::held_out_systems(24));
    EXPECT_GE(tried.systems, 300);
    known_dimensions::errors_are_right(tried);
    RecordProperty("systems", tried.systems);
    RecordProperty("measured", tried.measured);
    RecordProperty("beyond", tried.beyond);
}

}  // namespace
}  // namespace pxm::host
