// Decided open sets of systems of whole numbers that turn and reflect, checked by counting.
#include <gtest/gtest.h>

#include <random>

#include "tests/host/fractal/neighbours/certificates.hpp"

namespace pxm::test {
namespace {

TEST(Certificates, whole_systems_that_turn_agree_with_integers) {
    constexpr unsigned seed = 19'500;
    constexpr int systems = 500, levels = 4;
    std::mt19937 random(seed);
    Certified sums;
    for (int i = 0; i < systems; ++i) expect_certificate(random_whole_system(random), levels, sums);
    EXPECT_GT(sums.holds, systems / 5);
    EXPECT_GT(sums.fails, systems / 50);
    EXPECT_GT(sums.inside, 0);
    EXPECT_LT(sums.open, systems / 2);
    RecordProperty("holds", sums.holds);
    RecordProperty("fails", sums.fails);
    RecordProperty("inside", sums.inside);
    RecordProperty("open", sums.open);
}

}  // namespace
}  // namespace pxm::test
