// Laws of the woodgrain and its noise.
#include "dsp_kernels/texture_wood.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/floor_node.hpp"

namespace pxm::test {
namespace {

using namespace host;

const char* const floor_text =
    "texture t { wood size: 3,0.3 color: 1,1,1 color2: 0,0,0 } plane { normal: 0,1,0 texture: t }";

TEST(Noise, a_flipped_bit_flips_half_of_the_scrambled_bits) {
    FloorNode<float> node(compile_text(floor_text));
    std::mt19937 random(1);
    std::uniform_int_distribution<std::uint32_t> small(0, 63);
    for (int word = 0; word < 3; ++word) {
        for (int bit = 0; bit < 32; ++bit) {
            int flipped = 0;
            for (int trial = 0; trial < 200; ++trial) {
                std::uint32_t in[3] = {small(random), small(random), small(random)};
                const auto before = kernels::scramble(node, in[0], in[1], in[2]);
                in[word] ^= 1U << bit;
                flipped += std::popcount(before ^ kernels::scramble(node, in[0], in[1], in[2]));
            }
            EXPECT_NEAR(flipped / 200.0, 16, 5.5) << "word " << word << ", bit " << bit;
        }
    }
}

TEST(Noise, is_smooth_bounded_and_about_zero) {
    FloorNode<double> node(compile_text(floor_text));
    double sum = 0;
    int count = 0;
    for (double x = -30; x < 30; x += 0.37) {
        for (double y = -30; y < 30; y += 0.41) {
            const double value = kernels::noise(node, x, y, 5);
            EXPECT_LE(std::abs(value), 1);
            EXPECT_LT(std::abs(kernels::noise(node, x + 1e-4, y, 5) - value), 4e-4);
            sum += value;
            ++count;
        }
    }
    EXPECT_NEAR(sum / count, 0, 0.03);
}

TEST(Wood, filters_are_means_of_what_they_filter) {
    FloorNode<double> node(compile_text(floor_text));
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-3, 3);
    for (int trial = 0; trial < 100; ++trial) {
        const double x = place(random);
        const double width = std::exp2(place(random));
        double rings = 0;
        double stripes = 0;
        constexpr int steps = 20'000;
        for (int i = 0; i < steps; ++i) {
            const double at = x + width * ((i + 0.5) / steps - 0.5);
            const double f = at - std::floor(at);
            rings += f * f / steps;
            stripes += std::abs(at - std::round(at)) < 0.05 ? 1.0 / steps : 0;
        }
        EXPECT_NEAR(kernels::ring_darkness(node, x, width), rings, 1e-3);
        EXPECT_NEAR(kernels::share_in_stripes(node, x, width, 0.1), stripes, 1e-3);
    }
}

TEST(Wood, its_mean_does_not_change_with_distance) {
    FloorNode<float> node(compile_text(floor_text));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-400, 400);
    const double far = node.color({0.3, 0.3}, 1e7).x;
    for (const double diameter : {1e-3, 0.05, 0.5, 3.0, 50.0}) {
        double sum = 0;
        for (int i = 0; i < 4000; ++i) {
            // A circle of the world: a board is ten times as long as wide.
            sum += node.color({place(random), place(random)}, {diameter / 10, 0}, {0, diameter}).x;
        }
        EXPECT_NEAR(sum / 4000, far, 0.03) << diameter;
    }
}

TEST(Wood, fades_to_one_colour_far_away) {
    FloorNode<float> node(compile_text(floor_text));
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-400, 400);
    const auto spread = [&](double diameter) {
        double least = 1;
        double most = 0;
        for (int i = 0; i < 500; ++i) {
            const double color =
                node.color({place(random), place(random)}, {diameter / 10, 0}, {0, diameter}).x;
            least = std::min(least, color);
            most = std::max(most, color);
        }
        return most - least;
    };
    EXPECT_GT(spread(1e-3), 0.4);
    EXPECT_LT(spread(2), 0.03);
    EXPECT_LT(spread(30), 2e-3);
}

// Without a filter two pixels side by side differ by whole rings; with one, by what fits a pixel.
TEST(Wood, has_no_hard_edges_at_the_size_of_a_spot) {
    FloorNode<double> node(compile_text(floor_text));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-40, 40);
    for (const double diameter : {0.02, 0.1, 0.4}) {
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec2 at{place(random), place(random)};
            const glm::dvec2 minor{diameter / 10, 0};
            const glm::dvec2 major{0, diameter};
            const double here = node.color(at, minor, major).x;
            EXPECT_LT(std::abs(node.color(at + major / 20.0, minor, major).x - here), 0.12);
            EXPECT_LT(std::abs(node.color(at + minor / 20.0, minor, major).x - here), 0.12);
        }
    }
}

TEST(Wood, boards_differ_from_each_other) {
    FloorNode<float> node(compile_text(floor_text));
    int same = 0;
    for (int i = 0; i < 100; ++i) {
        const double a = node.color({0.5, i + 0.5}, 1e-3).x;
        const double b = node.color({0.5, i + 1.5}, 1e-3).x;
        same += std::abs(a - b) < 0.005 ? 1 : 0;
    }
    EXPECT_LT(same, 12);
}

}  // namespace
}  // namespace pxm::test
