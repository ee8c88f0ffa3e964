// Box counting on the systems that it was made with, and on a share of those of
// box_counting_full_test.cpp, which it was not.
#include <gtest/gtest.h>

#include "tests/host/fractal/dimension/known_dimensions.hpp"
#include "tests/support/held_out_systems.hpp"

namespace pxm::host {
namespace {

TEST(BoxCountingSlow, the_errors_of_19_systems_of_20_hold_the_dimension) {
    const known_dimensions::Tried tried = known_dimensions::try_all(systems::known_systems());
    known_dimensions::errors_are_right(tried);
}

TEST(BoxCountingSlow, so_do_those_of_19_of_20_that_it_was_not_made_with) {
    const known_dimensions::Tried tried = known_dimensions::try_all(systems::held_out_systems(1));
    known_dimensions::errors_are_right(tried);
}

}  // namespace
}  // namespace pxm::host
