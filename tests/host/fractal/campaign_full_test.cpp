// The campaigns over thousands of random systems.
#include "tests/host/fractal/campaign.hpp"

#include "host/fractal/dimension/similarity.hpp"

namespace pxm::host {
namespace {

TEST(Campaign, thousands_of_systems_lie_in_their_bounds) {
    for (unsigned seed = 0; seed < 4000; ++seed) {
        campaign::bounds_contain(seed);
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(Campaign, the_chaos_game_stays_on_thousands_of_attractors) {
    campaign::Tried all;
    for (unsigned seed = 0; seed < 4000; ++seed) {
        const campaign::Tried tried = campaign::points_lie_on_the_attractor(seed, 20);
        if (testing::Test::HasFailure()) return;
        all.points += tried.points;
        all.unknown += tried.unknown;
    }
    EXPECT_LT(all.unknown, all.points / 50) << "the search must decide to mean anything";
}

TEST(Campaign, adding_a_map_never_lowers_the_similarity_dimension) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> ratio(0.01, 0.98);
    for (int round = 0; round < 3000; ++round) {
        std::vector<Affine> maps;
        double last = 0;
        const int count = 2 + static_cast<int>(random() % 49);
        while (static_cast<int>(maps.size()) < count) {
            maps.push_back(scaling(glm::dvec3{ratio(random)}));
            const double dimension = similarity_dimension(systems::complete(maps)).value().middle();
            ASSERT_GE(dimension, last - 1e-9) << "round " << round;
            last = dimension;
        }
    }
}

}  // namespace
}  // namespace pxm::host
