#include "host/fractal/system/contraction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host/fractal/bounds/invariant_ball.hpp"
#include "host/fractal/system/cycle_mean.hpp"
#include "host/fractal/system/quadratic_norm.hpp"
#include "host/math/lipschitz.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

using systems::complete;
using systems::map;
using systems::with_graph;

Affine uniform(double ratio) { return scaling(glm::dvec3{ratio}); }

/// Lip above 2, but its powers vanish: both eigenvalues are 0.5.
Affine shear(double offset) {
    Affine result = uniform(0.5);
    result.linear[0][1] = 2;
    result.translation = {offset, offset / 2, 0};
    return result;
}

TEST(Contraction, every_system_of_the_thesis_contracts_map_by_map) {
    for (const auto& [name, rifs] : systems::thesis_systems()) {
        const Contraction contraction = prove_contraction(rifs);
        EXPECT_EQ(contraction.proof, ContractionProof::cycle_mean) << name;
        double largest = 0;
        for (const Affine& affine : rifs.maps)
            largest = std::max(largest, lipschitz_constant(affine));
        EXPECT_NEAR(contraction.rate, largest, 1e-12) << name;
    }
}

TEST(Contraction, a_map_of_norm_one_contracts_if_it_never_follows_itself) {
    const Rifs rifs = with_graph({rotation(Axis::x, 30), uniform(0.5)}, {{1}, {0, 1}});
    const Contraction contraction = prove_contraction(rifs);
    EXPECT_EQ(contraction.proof, ContractionProof::cycle_mean);
    EXPECT_NEAR(contraction.rate, std::sqrt(0.5), 1e-12);
}

TEST(Contraction, potentials_certify_the_cycle_mean) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        const Rifs rifs = systems::random_system(3 * seed, 1.3);
        const CycleMean worst = largest_cycle_mean(rifs);
        EXPECT_NEAR(worst.bound, worst.mean, 1e-9) << "seed " << 3 * seed;
        double sum = 0;
        for (std::size_t i = 0; i < worst.cycle.size(); ++i) {
            const int m = worst.cycle[i];
            const int next = worst.cycle[(i + 1) % worst.cycle.size()];
            const std::vector<int>& allowed = rifs.follow_sets[rifs.follow_of[m]].maps;
            EXPECT_EQ(std::count(allowed.begin(), allowed.end(), next), 1) << "seed " << 3 * seed;
            sum += std::log(lipschitz_constant(rifs.maps[m]));
        }
        EXPECT_NEAR(sum / static_cast<double>(worst.cycle.size()), worst.mean, 1e-12);
    }
}

TEST(Contraction, a_sheared_pair_contracts_in_an_ellipsoid_only) {
    const Rifs rifs = complete({shear(0), shear(1)});
    const Contraction contraction = prove_contraction(rifs);
    EXPECT_EQ(contraction.proof, ContractionProof::spectral_radius);
    EXPECT_GT(contraction.rate, 0.5);
    EXPECT_LT(contraction.rate, 1);
}

TEST(Contraction, every_map_takes_its_ellipsoid_into_the_next) {
    const Rifs rifs = with_graph({shear(0), shear(1), uniform(0.3)}, {{1, 2}, {0}, {0, 1, 2}});
    const auto norm = contracting_norm(rifs);
    ASSERT_TRUE(norm);
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        for (const int m : rifs.follow_sets[s].maps) {
            const Affine framed{glm::inverse(norm->frame[s]) * rifs.maps[m].linear *
                                norm->frame[rifs.follow_of[m]]};
            EXPECT_LE(lipschitz_constant(framed), norm->rate * (1 + 1e-9));
        }
    }
}

TEST(Contraction, five_sheared_maps_contract_by_words_only) {
    // The operator's radius is 5 * 0.25, but long words of a shear shrink.
    const Rifs rifs = complete({shear(0), shear(1), shear(2), shear(3), shear(4)});
    const Contraction contraction = prove_contraction(rifs);
    ASSERT_EQ(contraction.proof, ContractionProof::words);
    ASSERT_LT(contraction.rate, 1);
    Affine word;
    for (int i = 0; i < contraction.word_length; ++i) word = then(shear(0), word);
    EXPECT_LE(lipschitz_constant(word), std::pow(contraction.rate, contraction.word_length));
}

TEST(Contraction, a_rotation_alone_is_refused) {
    const Contraction contraction = prove_contraction(complete({rotation(Axis::y, 30)}));
    EXPECT_EQ(contraction.proof, ContractionProof::none);
    EXPECT_EQ(contraction.obstacle, "map 1 has Lipschitz constant 1");
}

TEST(Contraction, an_expanding_map_is_named) {
    Rifs rifs = complete({uniform(0.5), scaling({1.04, 0.5, 0.5})});
    rifs.map_names[1] = "stem";
    EXPECT_EQ(prove_contraction(rifs).obstacle, "map \"stem\" has Lipschitz constant 1.04");
}

TEST(Contraction, an_expanding_cycle_is_named) {
    const Rifs rifs = with_graph({uniform(0.5), uniform(2), uniform(0.6)}, {{1}, {2}, {0, 1}});
    const Contraction contraction = prove_contraction(rifs);
    EXPECT_EQ(contraction.proof, ContractionProof::none);
    EXPECT_TRUE(contraction.obstacle == "the cycle 2 -> 3 -> 2 grows by 1.2" ||
                contraction.obstacle == "the cycle 3 -> 2 -> 3 grows by 1.2")
        << contraction.obstacle;
}

TEST(Contraction, an_expanding_map_in_a_shrinking_two_cycle_is_accepted) {
    const Rifs rifs = with_graph({uniform(1.04), uniform(0.5)}, {{1}, {0}});
    EXPECT_EQ(prove_contraction(rifs).proof, ContractionProof::cycle_mean);
}

TEST(Contraction, the_zero_map_contracts) {
    EXPECT_EQ(prove_contraction(complete({uniform(0), uniform(0)})).proof,
              ContractionProof::cycle_mean);
}

TEST(Contraction, a_map_that_is_not_finite_is_refused) {
    Rifs rifs = systems::tetra();
    rifs.maps[2].translation.y = std::numeric_limits<double>::infinity();
    EXPECT_EQ(prove_contraction(rifs).obstacle, "map 3 is not finite");
}

TEST(Contraction, a_ring_of_65536_maps_is_measured_round_the_ring) {
    constexpr int length = 65'536;
    std::vector<Affine> maps;
    std::vector<std::vector<int>> follow;
    for (int m = 0; m < length; ++m) {
        maps.push_back(uniform(m % 2 == 0 ? 1.5 : 0.5));
        follow.push_back({(m + 1) % length});
    }
    const Contraction contraction = prove_contraction(with_graph(maps, follow));
    EXPECT_EQ(contraction.proof, ContractionProof::cycle_mean);
    EXPECT_NEAR(contraction.rate, std::sqrt(0.75), 1e-7);
}

/// Each of two maps vanishes if it is repeated; both in turn multiply by `growth`.
Rifs alternating(double size, double growth) {
    Affine there;
    there.linear = glm::dmat3{0.0};
    there.linear[0][2] = size;
    Affine back = there;
    std::swap(back.linear[0][2], back.linear[2][0]);
    back.linear[2][0] = growth / size;
    back.translation = {1, 0, 0};
    return complete({there, back});
}

TEST(Contraction, words_that_overflow_prove_nothing) {
    EXPECT_EQ(prove_contraction(alternating(2, 4)).proof, ContractionProof::none);
    EXPECT_EQ(prove_contraction(alternating(2, 3)).proof, ContractionProof::none);
    EXPECT_EQ(prove_contraction(alternating(1e160, 1e160)).proof, ContractionProof::none);
    Rifs with_middle = alternating(2, 4);
    for (Affine& affine : with_middle.maps) affine.linear[1][1] = 0.1;
    EXPECT_EQ(prove_contraction(with_middle).proof, ContractionProof::none);
}

TEST(Contraction, words_that_vanish_are_told_from_words_too_small_for_double) {
    EXPECT_NE(prove_contraction(alternating(1e160, 0.9)).proof, ContractionProof::none);
    EXPECT_NE(prove_contraction(alternating(1e-160, 0.9)).proof, ContractionProof::none);
    EXPECT_EQ(prove_contraction(alternating(1e160, 1.1)).proof, ContractionProof::none);
    EXPECT_EQ(prove_contraction(alternating(1e-160, 1.1)).proof, ContractionProof::none);
}

TEST(Contraction, volumes_of_what_was_not_proven_are_infinite) {
    const Rifs expanding = complete({uniform(0.5), map({uniform(1.5), translation({1, 0, 0})})});
    for (const ContractionProof claimed : {ContractionProof::cycle_mean, ContractionProof::none,
                                           ContractionProof::spectral_radius}) {
        const Contraction contraction{claimed, 0.5, 1, ""};
        const Bounds bounds = invariant_volumes(expanding, contraction, {{glm::dvec3{0.0}}})[0];
        EXPECT_EQ(bounds.ball.radius, std::numeric_limits<double>::infinity());
    }
}

}  // namespace
}  // namespace pxm::host
