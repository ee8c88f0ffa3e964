// Bounds, reaches and convex volumes of 100,000 systems, against points in 77 digits.
#include "tests/host/fractal/bounds/sure_bounds.hpp"

namespace pxm::host {
namespace {

TEST(SureBounds, of_a_hundred_thousand_systems_hold_in_77_digits_without_a_margin) {
    const sure_bounds::Tried tried = sure_bounds::try_systems(0, 100'000);
    EXPECT_GT(tried.systems, 50'000);
    EXPECT_GT(tried.short_without_rounding, 1'000);
    RecordProperty("systems", tried.systems);
    RecordProperty("reaches", tried.reaches);
    RecordProperty("short_without_rounding", tried.short_without_rounding);
}

}  // namespace
}  // namespace pxm::host
