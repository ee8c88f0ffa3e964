// Diameters of cells against singular values found another way (Ch. 16).
#include "dsp_kernels/diameter.hpp"

#include <gtest/gtest.h>

#include <random>

#include "host/math/lipschitz.hpp"
#include "host/node_program/native_node.hpp"

namespace pxm::test {
namespace {

template <class Real>
class Diameter : public testing::Test {};
using Reals = testing::Types<float, double, dsp32::Float>;
TYPED_TEST_SUITE(Diameter, Reals);

/// A matrix whose rows differ by up to 10^spread in size.
glm::dmat3 random_matrix(std::mt19937& random, double spread) {
    std::normal_distribution<double> entry;
    std::uniform_real_distribution<double> power(-spread, 0);
    glm::dmat3 m;
    for (int i = 0; i < 3; ++i) {
        const double size = std::pow(10.0, power(random));
        for (int j = 0; j < 3; ++j) m[i][j] = size * entry(random);
    }
    return m;
}

TYPED_TEST(Diameter, the_largest_singular_value_is_found_by_rotations) {
    using Real = TypeParam;
    host::NativeNode<Real> node({}, {}, 1, 4);
    std::mt19937 random(5);
    const double tolerance = real_words<Real> == 1 ? 3e-6 : 1e-14;
    for (const double spread : {0.0, 2.0, 6.0}) {
        for (const double size : {1e-6, 1.0, 1e6}) {
            for (int trial = 0; trial < 200; ++trial) {
                const glm::dmat3 m = random_matrix(random, spread) * size;
                kernels::Linear<Real> linear;
                for (int i = 0; i < 3; ++i) {
                    linear.rows[i] = {from_double<Real>(m[i][0]), from_double<Real>(m[i][1]),
                                      from_double<Real>(m[i][2])};
                }
                const double expected = host::singular_values(m).values[0];
                EXPECT_NEAR(to_double(kernels::largest_singular_value(node, linear)), expected,
                            tolerance * expected);
            }
        }
    }
}

TYPED_TEST(Diameter, nothing_is_as_large_as_nothing) {
    using Real = TypeParam;
    host::NativeNode<Real> node({}, {}, 1, 4);
    EXPECT_EQ(to_double(kernels::largest_singular_value(node, kernels::Linear<Real>{})), 0);
}

}  // namespace
}  // namespace pxm::test
