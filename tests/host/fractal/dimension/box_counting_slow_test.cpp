// Box counting on the systems that it was made with, and on a share of those of
// box_counting_full_test.cpp, which it was not.
#include <gtest/gtest.h>

#include "tests/host/fractal/dimension/known_dimensions.hpp"
#include "tests/support/held_out_systems.hpp"

namespace pxm::host {
namespace {

TEST(BoxCountingSlow, of_20_systems_19_are_within_two_errors) {
    const known_dimensions::Tried tried = known_dimensions::try_all(systems::known_systems());
    EXPECT_GE(tried.measured, 50);
    known_dimensions::errors_are_right(tried);
}

TEST(BoxCountingSlow, so_are_19_of_20_that_it_was_not_made_with) {
    const known_dimensions::Tried tried = known_dimensions::try_all(systems::held_out_systems(2));
    EXPECT_GE(tried.measured, 32);
    known_dimensions::errors_are_right(tried);
}

}  // namespace
}  // namespace pxm::host
