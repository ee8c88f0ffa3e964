// Bounds of large systems and of many random ones.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "host/fractal/bounds/bounds.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

/// Asserts that random points of some follow sets lie in their bounds.
void expect_contained(const Rifs& rifs, const std::vector<Bounds>& bounds, int depth,
                      unsigned seed) {
    std::mt19937_64 random(seed);
    const std::size_t stride = bounds.size() / 64 + 1;
    for (std::size_t s = 0; s < bounds.size(); s += stride) {
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 point =
                systems::random_point(rifs, static_cast<int>(s), depth, random);
            const auto& [ball, box, slack] = bounds[s];
            ASSERT_LE(glm::distance(point, ball.center), ball.radius) << "seed " << seed;
            for (int k = 0; k < 3; ++k) {
                ASSERT_GE(point[k], box.low[k]) << "seed " << seed;
                ASSERT_LE(point[k], box.high[k]) << "seed " << seed;
            }
        }
    }
}

std::vector<Affine> random_maps(int count, double largest, unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<Affine> maps;
    for (int i = 0; i < count; ++i) maps.push_back(systems::random_map(random, largest));
    return maps;
}

TEST(BoundsCampaign, random_systems_lie_in_their_bounds) {
    for (unsigned seed = 1000; seed < 1200; ++seed) {
        const double largest = seed % 10 == 0 ? 0.95 : 0.5 + 0.002 * (seed % 150);
        const Rifs rifs = systems::random_system(seed, largest);
        const auto bounds = bound(rifs, prove_contraction(rifs));
        expect_contained(rifs, bounds, static_cast<int>(-30 / std::log(largest)), seed);
    }
}

TEST(BoundsCampaign, systems_with_maps_that_expand_lie_in_their_bounds) {
    int accepted = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Rifs rifs = systems::random_system(3 * seed, 1.1);
        const Contraction contraction = prove_contraction(rifs);
        if (contraction.proof == ContractionProof::none || contraction.rate > 0.95) continue;
        ++accepted;
        expect_contained(rifs, bound(rifs, contraction), 800, seed);
    }
    EXPECT_GT(accepted, 3);
}

TEST(BoundsCampaign, a_thousand_maps_are_tight) {
    for (const double largest : {0.1, 0.3}) {
        const Rifs rifs = systems::complete(random_maps(1'000, largest, 7));
        const auto bounds = bound(rifs, prove_contraction(rifs));
        EXPECT_LE(bounds[0].ball_slack, 0.003);
        expect_contained(rifs, bounds, 40, 7);
    }
}

TEST(BoundsCampaign, a_thousand_maps_with_as_many_follow_sets_are_bounded) {
    std::vector<std::vector<int>> follow(1'000);
    for (int i = 0; i < 1'000; ++i) {
        for (int j = 0; j < 1'000; ++j) {
            if (j != i) follow[i].push_back(j);
        }
    }
    const Rifs rifs = systems::with_graph(random_maps(1'000, 0.3, 8), follow);
    const auto bounds = bound(rifs, prove_contraction(rifs));
    EXPECT_LE(bounds[0].ball_slack, 0.2);
    expect_contained(rifs, bounds, 40, 8);
}

TEST(BoundsCampaign, the_largest_systems_are_bounded) {
    constexpr int count = 65'536;
    const std::vector<Affine> maps = random_maps(count, 0.05, 9);
    std::vector<std::vector<int>> ring;
    std::vector<std::vector<int>> chain;
    for (int i = 0; i < count; ++i) {
        ring.push_back({(i + 1) % count, (7 * i + 3) % count});
        chain.push_back({std::min(i + 1, count - 1)});
    }
    for (const Rifs& rifs : {systems::complete(maps), systems::with_graph(maps, ring),
                             systems::with_graph(maps, chain)}) {
        const auto bounds = bound(rifs, prove_contraction(rifs));
        EXPECT_LE(bounds[0].ball_slack, 0.02);
        expect_contained(rifs, bounds, 20, 9);
    }
}

}  // namespace
}  // namespace pxm::host
