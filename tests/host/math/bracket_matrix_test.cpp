#include "host/math/bracket_matrix.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host/math/lipschitz.hpp"
#include "tests/host/fractal/proof_campaign.hpp"

namespace pxm::host {
namespace {

using proof_campaign::Numbers;
using proof_campaign::Real;

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_between(const Real& exact, const Bracket& bracket) {
    EXPECT_LE(Real{bracket.low}, exact);
    EXPECT_GE(Real{bracket.high}, exact);
}

TEST(Bracket, the_exact_result_lies_inside) {
    Numbers numbers(1);
    for (int i = 0; i < 500; ++i) {
        const double x = numbers.any_size(i % 2 == 0 ? 2 : 300);
        const double y = numbers.any_size(i % 2 == 0 ? 2 : 300);
        SCOPED_TRACE(testing::Message() << x << ' ' << y);
        expect_between(Real{x} + y, Bracket{x} + y);
        expect_between(Real{x} - y, Bracket{x} - y);
        expect_between(Real{x} * y, Bracket{x} * y);
        expect_between(Real{x} / y, Bracket{x} / y);
        expect_between(sqrt(abs(Real{x})), sqrt(Bracket{std::abs(x)}));
        // Of what is not one number but a range, too.
        const Bracket wide = Bracket{x} + Bracket{y} * 1e-3;
        expect_between((Real{x} + Real{y} / 1000) * x, wide * Bracket{x} + Bracket{0, 0});
    }
}

TEST(Bracket, what_double_cannot_hold_proves_nothing) {
    const double largest = std::numeric_limits<double>::max();
    for (const Bracket& lost :
         {Bracket{largest} * 2, Bracket{largest} + largest, Bracket{1} / Bracket{-1, 1},
          Bracket{infinity} * 0.0, Bracket{infinity} - infinity, Bracket{std::nan("")}}) {
        EXPECT_EQ(lost.low, -infinity);
        EXPECT_EQ(lost.high, infinity);
    }
}

TEST(Bracket, numbers_below_the_smallest_are_not_nothing) {
    const Bracket tiny = Bracket{1e-200} * 1e-200;
    EXPECT_GT(tiny.high, 0);
    EXPECT_LT(tiny.high, 1e-300);
    EXPECT_EQ((Bracket{1e-200} * 0.0).high, 0);
}

TEST(BracketMatrix, the_bound_of_a_norm_is_never_below_it_and_hardly_above) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        for (const Affine& map : proof_campaign::border_system(seed).maps) {
            const double bound = norm_at_most(map.linear);
            const auto exact = proof_campaign::real(map.linear);
            EXPECT_TRUE(proof_campaign::norm_at_most(exact, bound)) << "seed " << seed;
            EXPECT_FALSE(bound > 0 && proof_campaign::norm_at_most(exact, bound * (1 - 1e-13)))
                << "seed " << seed;
        }
    }
}

TEST(BracketMatrix, norms_beyond_doubles_squares_are_known) {
    for (const double size : {1e-320, 1e-200, 1e200, 1e307}) {
        const double bound = norm_at_most(glm::dmat3{size});
        EXPECT_GE(bound, size);
        EXPECT_LE(bound, size * 1.01);
    }
    EXPECT_EQ(norm_at_most(glm::dmat3{0.0}), 0);
    EXPECT_EQ(norm_at_most(glm::dmat3{infinity}), infinity);
    EXPECT_EQ(norm_at_most(glm::dmat3{std::nan("")}), infinity);
}

TEST(BracketMatrix, an_inverse_times_its_matrix_holds_the_identity) {
    Numbers numbers(2);
    for (int i = 0; i < 50; ++i) {
        glm::dmat3 lower{0.0};
        for (int c = 0; c < 3; ++c) {
            for (int r = c; r < 3; ++r) lower[c][r] = numbers.any_size(3);
        }
        const BracketMatrix product = inverse_of_lower(lower) * BracketMatrix{lower};
        for (int c = 0; c < 3; ++c) {
            for (std::size_t r = 0; r < 3; ++r) {
                const double one = static_cast<std::size_t>(c) == r ? 1 : 0;
                EXPECT_LE(product[c][r].low, one);
                EXPECT_GE(product[c][r].high, one);
            }
        }
    }
}

}  // namespace
}  // namespace pxm::host
