// A share of the campaigns of campaign_full_test.cpp, and that their referee can say no.
#include "tests/host/fractal/campaign.hpp"

namespace pxm::host {
namespace {

TEST(CampaignShare, systems_lie_in_their_bounds) {
    for (unsigned seed = 0; seed < 80; ++seed) {
        campaign::bounds_contain(seed);
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(CampaignShare, the_chaos_game_stays_on_the_attractor) {
    for (unsigned seed = 0; seed < 80; ++seed) {
        campaign::points_lie_on_the_attractor(seed, 5);
        if (testing::Test::HasFailure()) return;
    }
}

TEST(CampaignShare, membership_tells_points_off_the_gasket_from_points_on_it) {
    const Rifs gasket =
        systems::complete(systems::homotheties(0.5, {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}}));
    const auto bounds = bound(gasket, prove_contraction(gasket));
    campaign::Membership membership(gasket, bounds, 1e-6);
    EXPECT_EQ(membership.of({0.5, 0.5, 0}), campaign::Membership::Answer::on);
    EXPECT_EQ(membership.of({0.25, 0.75, 0}), campaign::Membership::Answer::on);
    EXPECT_EQ(membership.of({0.26, 0.26, 0}), campaign::Membership::Answer::off);
    EXPECT_EQ(membership.of({0.5, 0.5, 1e-4}), campaign::Membership::Answer::off);
}

}  // namespace
}  // namespace pxm::host
