// A share of the campaign of proof_campaign_full_test.cpp, and that its referee can say no.
#include "tests/host/fractal/proof_campaign.hpp"

namespace pxm::host {
namespace {

using proof_campaign::real;

TEST(ProofShare, what_is_proven_around_the_border_is_so) { proof_campaign::try_systems(0, 14, 14); }

TEST(ProofShare, the_referee_tells_eigenvalues_and_norms_from_the_border) {
    const glm::dmat3 turn = rotation(Axis::x, 40).linear;
    EXPECT_FALSE(proof_campaign::eigenvalues_below(real(turn), 1 - 1e-15));
    EXPECT_TRUE(proof_campaign::eigenvalues_below(real(turn), 1 + 1e-15));
    EXPECT_FALSE(proof_campaign::norm_at_most(real(turn), 1 - 1e-15));
    EXPECT_TRUE(proof_campaign::norm_at_most(real(turn), 1 + 1e-15));
    glm::dmat3 shear{0.5};
    shear[0][1] = 100;
    EXPECT_TRUE(proof_campaign::eigenvalues_below(real(shear), proof_campaign::Real{0.5} + 1e-20));
    EXPECT_FALSE(proof_campaign::norm_at_most(real(shear), 100));
    EXPECT_TRUE(proof_campaign::norm_at_most(real(shear), 100.01));
}

}  // namespace
}  // namespace pxm::host
