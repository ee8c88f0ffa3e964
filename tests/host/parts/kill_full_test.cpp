// The campaign of kill_slow_test.cpp: 300 kills of each kind of work.
#include <gtest/gtest.h>

#include "tests/support/kills.hpp"

namespace pxm::test {
namespace {

class KillCampaign : public testing::TestWithParam<std::size_t> {};

TEST_P(KillCampaign, leaves_the_old_or_the_new_and_the_next_run_goes_on) {
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    const KilledWork work = killed_works().at(GetParam());
    kill_at_random(work, 300, random);
    if (HasFailure()) FAIL() << testing::PrintToString(work.command);
}

INSTANTIATE_TEST_SUITE_P(OfEachWork, KillCampaign,
                         testing::Range(std::size_t{0}, killed_works().size()));

}  // namespace
}  // namespace pxm::test
