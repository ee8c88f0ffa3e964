// The laws of host/studio/deadline.hpp: work that does not get on is stopped all the same.
#include "host/studio/deadline.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace pxm::host {
namespace {

TEST(Deadline, stops_work_that_says_nothing) {
    std::atomic<bool> stop = false;
    const Deadline deadline(stop, 0.002);
    while (!stop) std::this_thread::yield();
    EXPECT_TRUE(deadline.has_passed());
}

TEST(Deadline, is_no_more_once_the_work_has_ended) {
    std::atomic<bool> stop = false;
    const auto begin = std::chrono::steady_clock::now();
    { const Deadline deadline(stop, 1000); }
    EXPECT_FALSE(stop);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(100));
}

TEST(Deadline, has_not_passed_for_what_others_have_stopped) {
    std::atomic<bool> stop = true;
    const Deadline deadline(stop, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_FALSE(deadline.has_passed());
}

}  // namespace
}  // namespace pxm::host
