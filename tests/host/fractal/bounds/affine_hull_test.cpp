// How much work affine hulls are: counted, since times decide no test.
#include "host/fractal/bounds/affine_hull.hpp"

#include <gtest/gtest.h>

#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

/// As many different follow sets as maps: each may be followed by all but itself.
Rifs many_sets(int maps, const glm::dvec3& along) {
    std::vector<Affine> moves;
    std::vector<std::vector<int>> follow(static_cast<std::size_t>(maps));
    for (int m = 0; m < maps; ++m) {
        const double place = static_cast<double>(m) / maps;
        moves.push_back(
            systems::map({scaling(glm::dvec3{0.5 / maps}), translation(place * along)}));
        for (int next = 0; next < maps; ++next) {
            if (next != m) follow[static_cast<std::size_t>(m)].push_back(next);
        }
    }
    return systems::with_graph(moves, follow);
}

std::size_t edges_of(const Rifs& rifs) {
    std::size_t edges = 0;
    for (const FollowSet& set : rifs.follow_sets) edges += set.maps.size();
    return edges;
}

TEST(AffineHull, an_edge_is_looked_at_four_times_at_most) {
    for (const int maps : {10, 40, 160}) {
        const Rifs rifs = many_sets(maps, {1, 0.5, 0.25});
        const HullSearch found = search_affine_hulls(rifs);
        EXPECT_LE(found.edges_looked_at, 4 * edges_of(rifs)) << maps;
        for (const AffineHull& hull : found.hulls) EXPECT_EQ(hull.dimension, 1) << maps;
    }
}

TEST(AffineHull, a_long_ring_takes_steps_as_it_has_maps) {
    constexpr int maps = 2'000;
    std::vector<Affine> moves;
    std::vector<std::vector<int>> follow;
    for (int m = 0; m < maps; ++m) {
        moves.push_back(
            systems::map({scaling(glm::dvec3{m == 0 ? 0.5 : 1}), translation({1, 0, 0})}));
        follow.push_back({(m + 1) % maps});
    }
    const Rifs rifs = systems::with_graph(moves, follow);
    EXPECT_LE(search_affine_hulls(rifs).edges_looked_at, 4 * edges_of(rifs));
}

}  // namespace
}  // namespace pxm::host
