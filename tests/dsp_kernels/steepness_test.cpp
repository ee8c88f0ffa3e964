// Laws of dsp_kernels/steepness.hpp.
#include "dsp_kernels/steepness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host/node_program/native_node.hpp"

namespace pxm::test {
namespace {

template <class Real>
class Steepness : public testing::Test {
  protected:
    using Vector = kernels::Vec3<Real>;

    static Vector vector(double x, double y, double z) {
        return {from_double<Real>(x), from_double<Real>(y), from_double<Real>(z)};
    }
    Vector shortened(Vector v) {
        kernels::shorten(node_, v);
        return v;
    }
    static double sum(const Vector& v) {
        return std::abs(to_double(v.x)) + std::abs(to_double(v.y)) + std::abs(to_double(v.z));
    }

    const std::vector<std::uint32_t> block_;
    const std::vector<std::uint32_t> no_textures_;
    host::NativeNode<Real> node_{block_, no_textures_, 1, 4};
    const double longest_ = to_double(kernels::longest_direction<Real>);
};

using Numbers = testing::Types<dsp32::Float, float>;
TYPED_TEST_SUITE(Steepness, Numbers);

TYPED_TEST(Steepness, a_direction_that_can_be_squared_stays_as_it_is) {
    for (const double length : {0.0, 1.0, 3e7, this->longest_ / 4}) {
        const auto v = this->vector(length, -length / 3, length / 7);
        const auto w = this->shortened(v);
        EXPECT_EQ(w.x, v.x);
        EXPECT_EQ(w.y, v.y);
        EXPECT_EQ(w.z, v.z);
    }
}

TYPED_TEST(Steepness, a_longer_one_keeps_its_course_and_all_its_digits) {
    const double most = to_double(largest<TypeParam>) / 8;
    for (double length = this->longest_; length < most; length *= 1e3) {
        const auto v = this->vector(length, -length / 3, length / 1e5);
        const auto w = this->shortened(v);
        const double factor = to_double(w.x) / to_double(v.x);
        int exponent = 0;
        EXPECT_EQ(std::frexp(factor, &exponent), 0.5) << "no power of two at " << length;
        EXPECT_EQ(to_double(w.y), to_double(v.y) * factor);
        EXPECT_EQ(to_double(w.z), to_double(v.z) * factor);
        EXPECT_LE(this->sum(w), this->longest_);
        EXPECT_GT(this->sum(w), this->longest_ * to_double(kernels::shortening<TypeParam>) / 2);
    }
}

TYPED_TEST(Steepness, what_is_beyond_the_range_ends) {
    const double beyond = std::numeric_limits<double>::infinity();
    const auto w = this->shortened(this->vector(1, beyond, -1));
    EXPECT_GT(to_double(w.y), 0.0);
}

TYPED_TEST(Steepness, rows_keep_their_ratios) {
    const double l = this->longest_;
    kernels::Linear<TypeParam> rows{
        {this->vector(l, 1, 2), this->vector(3, l * 8, 4), this->vector(5, 6, l / 2)}};
    kernels::shorten(this->node_, rows);
    EXPECT_EQ(to_double(rows.rows[1].y), 8 * to_double(rows.rows[0].x));
    EXPECT_EQ(to_double(rows.rows[0].x), 2 * to_double(rows.rows[2].z));
    EXPECT_EQ(to_double(rows.rows[2].y), 6 * to_double(rows.rows[0].y));
    EXPECT_LT(to_double(rows.rows[1].y), l);
}

}  // namespace
}  // namespace pxm::test
