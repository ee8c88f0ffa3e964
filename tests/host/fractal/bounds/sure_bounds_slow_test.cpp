// A share of the campaign of sure_bounds_full_test.cpp, and what the proof of a reach makes of the
// cells that were left out.
#include "tests/host/fractal/bounds/sure_bounds.hpp"

#include "host/fractal/bounds/reach_proof.hpp"

namespace pxm::host {
namespace {

TEST(SureBounds, hold_in_77_digits_without_a_margin) {
    const sure_bounds::Tried tried = sure_bounds::try_systems(0, 300);
    EXPECT_GT(tried.systems, 200);
    EXPECT_GT(tried.short_without_rounding, 10) << "the law must be able to fail";
}

TEST(ReachProof,
     a_cell_left_out_for_one_that_holds_it_reaches_as_far_as_its_point_that_stands_still) {
    // All there is reaches h, and in it a cell 1 + h / 2: h is 2, whatever is known before.
    ReachProof proof;
    proof.add(-1, 100);
    proof.expand(0);
    proof.drop(0, 51, {0, 0.5, 1});
    EXPECT_GE(proof.at_most(2), 2);
    EXPECT_LT(proof.at_most(2), 2 + 1e-9);
    EXPECT_GE(proof.at_most(0), 2);
}

TEST(ReachProof, cells_left_out_for_each_other_prove_nothing) {
    ReachProof proof;
    proof.add(-1, 100);
    proof.expand(0);
    proof.add(0, 60);
    proof.add(0, 70);
    proof.leave_out(1, {2, 1, 0});
    proof.leave_out(2, {1, 1, 0});
    EXPECT_GE(proof.at_most(1), 60);
}

TEST(ReachProof, what_rounding_took_adds_up_along_the_cells_left_out_for_others) {
    ReachProof proof;
    proof.add(-1, 100);
    proof.expand(0);
    proof.add(0, 1);
    for (int i = 0; i < 10; ++i) proof.add(0, 50);
    for (int i = 0; i < 10; ++i) proof.leave_out(i + 2, {i + 1, 1, 1e-3, 1e-3});
    EXPECT_GE(proof.at_most(1), 1.01);
    EXPECT_LT(proof.at_most(1), 1.05);
}

TEST(SureBounds, what_double_cannot_hold_is_bounded_by_infinity_alone) {
    // The point (8e156, 0.25, 0.9): squares on the way to it are beyond the largest double.
    Affine huge{glm::dmat3{0.0}, {0.5, 0.25, 0.9}};
    huge.linear[1][0] = 3.35e157;
    const Rifs rifs = systems::complete({huge});
    const Contraction proof = prove_contraction(rifs);
    ASSERT_NE(proof.proof, ContractionProof::none);
    proof_campaign::volumes_contain(rifs, bound(rifs, proof), 2);
}

TEST(SureBounds, a_set_far_away_sticks_out_of_no_bound) {
    for (const double far : {1e3, 1e6, 1e9, 1e12}) {
        const Affine away = translation(glm::dvec3{far, far / 3, -far});
        Rifs rifs = systems::elm();
        for (Affine& map : rifs.maps) map = then(then(inverse(away), map), away);
        proof_campaign::volumes_contain(rifs, bound(rifs, prove_contraction(rifs)), 2);
    }
}

}  // namespace
}  // namespace pxm::host
