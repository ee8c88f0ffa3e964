// Laws of what threads make in any order.
#include "host/process/in_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

namespace pxm::host {
namespace {

TEST(InOrder, hands_on_all_things_by_their_numbers_whatever_order_they_come_in) {
    std::mt19937 random(11);
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<long> numbers(static_cast<std::size_t>(random() % 40));
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<long>(i);
        std::vector<long> expected = numbers;
        std::ranges::shuffle(numbers, random);
        InOrder<long> in_order;
        std::vector<long> got;
        for (const long number : numbers)
            in_order.add(number, number, [&](long thing) { got.push_back(thing); });
        EXPECT_EQ(got, expected);
    }
}

// A writer of EXR that is called again after a write that failed never returns.
TEST(InOrder, takes_nothing_more_after_what_has_thrown) {
    InOrder<long> in_order;
    std::vector<long> got;
    const auto take = [&](long thing) {
        got.push_back(thing);
        if (thing == 1) throw std::runtime_error("full");
    };
    in_order.add(0, 0, take);
    in_order.add(2, 2, take);
    EXPECT_THROW(in_order.add(1, 1, take), std::runtime_error);
    in_order.add(3, 3, take);
    EXPECT_EQ(got, (std::vector<long>{0, 1}));
}

}  // namespace
}  // namespace pxm::host
