// All that is called a proof of contraction, on 100,000 systems around the border.
#include "tests/host/fractal/proof_campaign.hpp"

namespace pxm::host {
namespace {

TEST(ProofCampaign, a_hundred_thousand_systems_around_the_border_hold_in_77_digits) {
    const proof_campaign::Tried tried = proof_campaign::try_systems(0, 100'000, 100);
    for (const ContractionProof proof :
         {ContractionProof::cycle_mean, ContractionProof::spectral_radius,
          ContractionProof::words}) {
        EXPECT_GT(tried.found.at(proof), 1'000) << "of a kind of proof there must be some to try";
    }
    EXPECT_GT(tried.growing, 10'000);
    for (const auto& [proof, count] : tried.found) {
        RecordProperty("proof_" + std::to_string(static_cast<int>(proof)), count);
    }
    RecordProperty("growing", tried.growing);
}

}  // namespace
}  // namespace pxm::host
