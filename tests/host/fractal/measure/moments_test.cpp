// The mean and the spread of measures that are known in closed form lie within the errors told.
#include "host/fractal/measure/moments.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/fractal/bounds/inner_points.hpp"
#include "host/fractal/measure/diameter.hpp"
#include "host/fractal/system/contraction.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

using systems::complete;
using systems::homotheties;

// Of r x and r x + 1 - r with shares p and q: the mean is q, the variance p q (1 - r) / (1 + r).
TEST(Moments, lie_within_their_errors) {
    for (const double r : {0.01, 0.3, 1.0 / 3, 0.5, 0.7, 0.99}) {
        for (const double p : {0.1, 0.5, 0.8}) {
            for (const double far : {0.0, 1e3}) {
                Rifs rifs = complete(homotheties(r, {{0, 0, 0}, {1 - r, 0, 0}}));
                for (Affine& map : rifs.maps) map.translation.y = (1 - r) * far;
                const auto found = moments(rifs, {p, 1 - p});
                ASSERT_TRUE(found);
                // What 1 - r and the like are off by is within the maps.
                const double given = 1e-15 * (1 + far) / (1 - r);
                EXPECT_NEAR(found->centroid.x, 1 - p, found->centroid_error + given);
                EXPECT_NEAR(found->centroid.y, far, found->centroid_error + given);
                const double variance = p * (1 - p) * (1 - r) / (1 + r);
                EXPECT_NEAR(found->variances[0], variance, found->variance_error + given);
                EXPECT_NEAR(found->variances[1], 0, found->variance_error);
                EXPECT_LT(found->centroid_error, 1e-10 * (1 + far) / (1 - r));
                EXPECT_EQ(found->axis_errors[2], 1) << "two variances are 0";
                if (far == 0) {
                    EXPECT_LT(found->axis_errors[0], 1e-8 / (1 - r));
                }
            }
        }
    }
}

TEST(Diameter, is_between_its_bounds) {
    for (const double r : {0.1, 1.0 / 3, 0.5, 0.6}) {
        const Rifs rifs =
            complete(homotheties(r, {{0, 0, 0}, {1 - r, 0, 0}, {0, 1 - r, 0}, {1 - r, 1 - r, 0}}));
        const Diameter found =
            diameter(rifs, bound(rifs, prove_contraction(rifs)), inner_points(rifs));
        EXPECT_LE(found.lower, std::sqrt(2) * (1 + 1e-15));
        EXPECT_GE(found.upper, std::sqrt(2) * (1 - 1e-15));
        EXPECT_GT(found.lower, std::sqrt(2) * (1 - 1e-9));
        EXPECT_LT(found.upper, std::sqrt(2) * (1 + 1e-5));
        EXPECT_LE(found.lower, found.value);
    }
}

}  // namespace
}  // namespace pxm::host
