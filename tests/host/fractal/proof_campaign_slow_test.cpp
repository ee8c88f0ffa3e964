// A larger share of the campaign of proof_campaign_full_test.cpp.
#include "tests/host/fractal/proof_campaign.hpp"

namespace pxm::host {
namespace {

TEST(ProofShare, thousands_of_proofs_around_the_border_hold_in_77_digits) {
    const proof_campaign::Tried tried = proof_campaign::try_systems(40, 3'000, 50);
    for (const ContractionProof proof :
         {ContractionProof::cycle_mean, ContractionProof::spectral_radius,
          ContractionProof::words}) {
        EXPECT_GT(tried.found.at(proof), 20) << "of a kind of proof there must be some to try";
    }
    EXPECT_GT(tried.growing, 200);
}

}  // namespace
}  // namespace pxm::host
