// The exponent of a graph whose steps have one ratio, by one iteration, against the one that tries
// exponents.
#include "host/fractal/neighbours/graph_growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace pxm::test {
namespace {

using host::growth_exponent;
using host::GrowthGraph;

/// A cycle through all states, so that each leads to each, and other steps.
GrowthGraph random_graph(std::mt19937& random, double log_ratio) {
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const int states = 1 + below(30);
    GrowthGraph graph(static_cast<std::size_t>(states));
    for (int s = 0; s < states; ++s) {
        auto& steps = graph[static_cast<std::size_t>(s)];
        steps.push_back({(s + 1) % states, log_ratio});
        for (int more = below(3); more > 0; --more) steps.push_back({below(states), log_ratio});
    }
    graph[0].push_back({0, log_ratio});
    return graph;
}

TEST(GraphGrowth, one_iteration_finds_what_trying_exponents_does) {
    constexpr unsigned seed = 19'700;
    std::mt19937 random(seed);
    for (int i = 0; i < 40; ++i) {
        GrowthGraph graph = random_graph(random, -std::log(2 + i % 3));
        const auto at_once = growth_exponent(graph);
        ASSERT_TRUE(at_once);
        EXPECT_LT(at_once->error(), 1e-12);
        graph[0][0].log_ratio *= 1 + 1e-13;  // no longer one ratio
        const auto tried = growth_exponent(graph);
        ASSERT_TRUE(tried);
        EXPECT_NEAR(at_once->middle(), tried->middle(), 1e-9) << i;
    }
}

TEST(GraphGrowth, golden_words_grow_by_the_golden_ratio) {
    const double half = -std::log(2.0);
    const auto found = growth_exponent({{{0, half}, {1, half}}, {{0, half}}});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->middle(), std::log(std::numbers::phi) / std::log(2.0), 1e-14);
}

}  // namespace
}  // namespace pxm::test
