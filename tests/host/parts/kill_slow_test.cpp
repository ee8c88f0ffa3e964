// Laws of sudden ends, at a few random moments; kill_full_test.cpp has hundreds.
#include <gtest/gtest.h>

#include "tests/support/kills.hpp"

namespace pxm::test {
namespace {

TEST(Kills, leave_the_old_or_the_new_and_the_next_run_goes_on) {
    std::mt19937 random(1991);
    for (const KilledWork& work : killed_works()) {
        kill_at_random(work, 6, random);
        if (HasFailure()) FAIL() << testing::PrintToString(work.command);
    }
}

}  // namespace
}  // namespace pxm::test
