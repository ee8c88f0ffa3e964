// Laws of exceptions in parallel loops: the first is thrown again, after the threads, and no step
// is begun after it.
#include "host/process/first_failure.hpp"

#include <gtest/gtest.h>

#include <new>
#include <vector>

#include "host/engine/threads.hpp"
#include "pxm/scheduler.hpp"

namespace pxm::host {
namespace {

TEST(FirstFailure, what_a_step_of_a_shared_loop_throws_comes_out_behind_it) {
    FirstFailure failure;
    std::atomic<int> steps = 0;
#pragma omp parallel num_threads(3)
    {
#pragma omp for schedule(dynamic) nowait
        for (int i = 0; i < 10'000; ++i) {
            failure.guard([&] {
                ++steps;
                if (i >= 100) throw std::bad_alloc();
            });
        }
    }
    EXPECT_THROW(failure.rethrow(), std::bad_alloc);
    EXPECT_LE(steps, 100 + 3) << "each thread may have been in one";
}

TEST(FirstFailure, without_one_nothing_is_thrown) {
    FirstFailure failure;
    int steps = 0;
    failure.guard([&] { ++steps; });
    EXPECT_NO_THROW(failure.rethrow());
    EXPECT_EQ(steps, 1);
}

TEST(Scheduler, what_a_node_throws_comes_out_and_no_node_is_begun_after_it) {
    for (const int threads : {1, 3}) {
        std::atomic<int> begun = 0;
        const auto work = [&](int node) {
            ++begun;
            if (node >= 10) throw std::bad_alloc();
        };
        EXPECT_THROW(for_each_node(10'000, threads, work), std::bad_alloc);
        EXPECT_LE(begun, 10 + threads) << "each thread may have been in one";
    }
}

TEST(Scheduler, each_node_is_done_once_on_any_number_of_threads) {
    for (const int threads : {-1, 0, 1, 2, 7}) {
        std::vector<std::atomic<int>> done(100);
        for_each_node(100, threads, [&](int node) { ++done[static_cast<std::size_t>(node)]; });
        for (const auto& one : done) EXPECT_EQ(one, 1);
    }
}

TEST(Threads, there_is_at_least_one_and_never_more_than_wanted) {
    EXPECT_EQ(threads_that_start(0), 1);
    EXPECT_EQ(threads_that_start(1), 1);
    EXPECT_LE(threads_that_start(3), 3);
    EXPECT_LE(threads_that_start(2), 2);
    EXPECT_GE(threads_that_start(2), 1);
}

}  // namespace
}  // namespace pxm::host
