// The laws of host/studio/turns.hpp and presence.hpp: the newest question wins.
#include "host/studio/turns.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "host/studio/presence.hpp"

namespace pxm::host {
namespace {

using namespace std::chrono_literals;

TEST(Turns, a_newer_question_stops_the_one_under_way) {
    Turns turns(4);
    auto first = turns.take("a", 1);
    ASSERT_TRUE(first);
    EXPECT_FALSE(first->stop());
    auto second = std::async(std::launch::async, [&] { return turns.take("a", 2).has_value(); });
    while (!first->stop()) std::this_thread::yield();
    EXPECT_EQ(second.wait_for(20ms), std::future_status::timeout) << "it waits for the first";
    first.reset();
    EXPECT_TRUE(second.get());
}

TEST(Turns, a_turn_knows_since_when_it_is_to_stop) {
    Turns turns(4);
    const auto turn = turns.take("a", 1);
    ASSERT_TRUE(turn);
    EXPECT_EQ(turn->stopping_milliseconds(), 0);
    turns.leave("a");
    std::this_thread::sleep_for(3ms);
    const double first = turn->stopping_milliseconds();
    EXPECT_GE(first, 3);
    turns.close();
    std::this_thread::sleep_for(1ms);
    EXPECT_GT(turn->stopping_milliseconds(), first) << "only the first to ask counts";
}

TEST(Turns, what_was_overtaken_is_never_begun) {
    Turns turns(4);
    auto first = turns.take("a", 1);
    auto second = std::async(std::launch::async, [&] { return turns.take("a", 2).has_value(); });
    while (!first->stop()) std::this_thread::yield();
    auto third = std::async(std::launch::async, [&] { return turns.take("a", 3).has_value(); });
    EXPECT_FALSE(second.get());
    first.reset();
    EXPECT_TRUE(third.get());
    EXPECT_FALSE(turns.take("a", 2)) << "an old question that comes late";
    EXPECT_FALSE(turns.take("a", 3)) << "the same question again";
}

TEST(Turns, pages_do_not_disturb_each_other) {
    Turns turns(4);
    const auto a = turns.take("a", 7);
    const auto b = turns.take("b", 1);
    ASSERT_TRUE(a && b);
    EXPECT_FALSE(a->stop());
    EXPECT_FALSE(b->stop());
}

TEST(Turns, so_many_compute_at_once) {
    Turns turns(2);
    std::atomic<int> inside = 0, most = 0, done = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 12; ++i) {
        threads.emplace_back([&, i] {
            const auto turn = turns.take("view" + std::to_string(i), 1);
            ASSERT_TRUE(turn);
            const int now = ++inside;
            if (now > most) most = now;
            std::this_thread::sleep_for(2ms);
            --inside;
            ++done;
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(done, 12);
    EXPECT_LE(most, 2);
}

TEST(Turns, a_page_that_leaves_stops_all_that_it_asked_for) {
    Turns turns(4);
    const auto picture = turns.take("abc-picture", 1);
    const auto inspect = turns.take("abc-inspect", 2);
    const auto other = turns.take("abd-picture", 1);
    turns.leave("abc");
    EXPECT_TRUE(picture->stop());
    EXPECT_TRUE(inspect->stop());
    EXPECT_FALSE(other->stop());
}

TEST(Turns, there_are_only_so_many_views) {
    Turns turns(1000);
    std::vector<Turns::Turn> taken;
    for (std::size_t i = 0; i < Turns::most_views; ++i)
        taken.push_back(*turns.take("view" + std::to_string(i), 1));
    EXPECT_FALSE(turns.take("one more", 1));
    taken.pop_back();
    EXPECT_TRUE(turns.take("one more", 1)) << "an idle one makes room";
}

TEST(Turns, after_the_end_nobody_has_a_turn) {
    Turns turns(1);
    const auto first = turns.take("a", 1);
    auto waiting = std::async(std::launch::async, [&] { return turns.take("b", 1).has_value(); });
    EXPECT_EQ(waiting.wait_for(20ms), std::future_status::timeout);
    turns.close();
    EXPECT_TRUE(first->stop());
    EXPECT_FALSE(waiting.get());
    EXPECT_FALSE(turns.take("c", 1));
}

TEST(Presence, counts_from_when_the_last_page_left) {
    Presence presence;
    int left = 0;
    EXPECT_LT(presence.seconds_alone(), 0) << "nobody has come yet";
    auto a = presence.enter([&] { ++left; });
    auto b = presence.enter([&] { ++left; });
    EXPECT_TRUE(a) << "what is held tells whether it is";
    EXPECT_EQ(presence.pages(), 2);
    a.reset();
    EXPECT_EQ(left, 1);
    EXPECT_LT(presence.seconds_alone(), 0);
    b.reset();
    EXPECT_EQ(presence.pages(), 0);
    EXPECT_NEAR(presence.seconds_alone(Presence::Clock::now() + 10s), 10, 5);
    const auto c = presence.enter([] {});
    EXPECT_LT(presence.seconds_alone(Presence::Clock::now() + 10s), 0);
}

TEST(Presence, may_end_before_a_page_does) {
    auto presence = std::make_unique<Presence>();
    auto page = presence->enter([] { FAIL() << "there is nobody to tell"; });
    presence.reset();
    page.reset();
}

}  // namespace
}  // namespace pxm::host
