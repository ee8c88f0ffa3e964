// Laws of pictures as textures: orientation, magnification, and that distance averages.
#include "dsp_kernels/texture_image.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "host/compile/image_levels.hpp"
#include "tests/support/floor_node.hpp"
#include "tests/support/folder.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr double ten_bits = 1.0 / 1023;  // a step of a texel's square root near 1

LinearPicture random_picture(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0, 2);
    LinearPicture picture{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
        picture.pixels.push_back({value(random), value(random), value(random)});
    }
    return picture;
}

glm::dvec3 mean_of(const LinearPicture& picture) {
    glm::dvec3 sum{0.0};
    for (const auto& texel : picture.pixels) sum += glm::dvec3{texel[0], texel[1], texel[2]};
    return sum / static_cast<double>(picture.pixels.size());
}

TEST(ImageLevels, every_level_has_the_mean_of_the_picture) {
    for (const auto& [width, height] : {std::pair{64, 64}, {37, 53}, {1, 17}, {100, 3}, {1, 1}}) {
        const auto levels = make_levels(random_picture(width, height, 3));
        for (const LinearPicture& level : levels) {
            EXPECT_LT(glm::distance(mean_of(level), mean_of(levels[0])), 1e-5)
                << width << "x" << height << " at " << level.width << "x" << level.height;
        }
        EXPECT_EQ(levels.back().pixels.size(), 1U);
    }
}

TEST(ImageLevels, of_powers_of_two_are_means_of_four) {
    const auto levels = make_levels(random_picture(8, 4, 5));
    ASSERT_EQ(levels.size(), 4U);
    const auto& from = levels[0].pixels;
    const float four = (from[2][1] + from[3][1] + from[10][1] + from[11][1]) / 4;
    EXPECT_NEAR(levels[1].pixels[1][1], four, 1e-6);
}

TEST(ImageLevels, what_is_no_brightness_becomes_none) {
    LinearPicture picture{2, 1, {}};
    picture.pixels.push_back({-1, std::nanf(""), 1e30F});
    picture.pixels.push_back({1, 0, 0});
    const LinearPicture level = make_levels(picture)[0];
    EXPECT_EQ(level.pixels[0][0], 0);
    EXPECT_EQ(level.pixels[0][1], 0);
    EXPECT_EQ(level.pixels[0][2], 1e6F);
}

class ImageTexture : public testing::Test {
  protected:
    Folder folder_;
    std::string path_ = folder_.path("a.exr");

    [[nodiscard]] CompiledScene scene() const {
        return compile_text(
            fmt::format("texture t {{ file: \"{}\" }}\n"
                        "plane {{ normal: 0,1,0 texture: t }}",
                        path_));
    }
};

TEST_F(ImageTexture, stands_upright_with_its_lower_left_corner_at_the_origin) {
    write_picture(path_, 2, 2, [](long x, long y) {
        return glm::dvec3{static_cast<double>(x), static_cast<double>(y), 0};
    });
    FloorNode<float> node(scene());
    const auto at = [&](double u, double v) { return node.color({u, v}, 1e-3); };
    EXPECT_LT(glm::distance(at(0.25, 0.25), {0, 1, 0}), 1e-6);  // the second row is below
    EXPECT_LT(glm::distance(at(0.75, 0.25), {1, 1, 0}), 1e-6);
    EXPECT_LT(glm::distance(at(0.25, 0.75), {0, 0, 0}), 1e-6);
    EXPECT_LT(glm::distance(at(0.75, 0.75), {1, 0, 0}), 1e-6);
    EXPECT_LT(glm::distance(at(0.5, 0.5), {0.5, 0.5, 0}), 1e-6);  // bilinear
    EXPECT_LT(glm::distance(at(1, -3.75), {0.5, 1, 0}), 1e-5);    // and around
}

TEST_F(ImageTexture, brighter_than_white_is_kept) {
    write_picture(path_, 1, 1, [](long, long) { return glm::dvec3{0.25, 4, 16}; });
    FloorNode<float> node(scene());
    const glm::dvec3 color = node.color({0.3, 0.4}, 0.1);
    EXPECT_NEAR(color.x, 0.25, 2 * 4 * 0.5 * ten_bits);
    EXPECT_NEAR(color.y, 4, 2 * 8 * ten_bits);
    EXPECT_NEAR(color.z, 16, 1e-4);
}

TEST_F(ImageTexture, from_far_away_a_checker_is_its_mean) {
    write_picture(path_, 48, 48, [](long x, long y) {
        return (x / 12 + y / 12) % 2 == 0 ? glm::dvec3{1, 0.5, 0} : glm::dvec3{0, 0.5, 0.2};
    });
    const glm::dvec3 mean{0.5, 0.5, 0.1};
    FloorNode<float> node(scene());
    FloorNode<dsp32::Float> chip(scene());
    for (const double diameter : {1.0, 3.0, 1e4, 1e7}) {
        EXPECT_LT(glm::distance(node.color({0.1, 0.7}, diameter), mean), 2 * ten_bits);
        EXPECT_LT(glm::distance(chip.color({0.1, 0.7}, diameter), mean), 2 * ten_bits);
    }
    EXPECT_LT(glm::distance(node.color({3e6, 0.7}, 1e-3), mean), 2 * ten_bits);  // no digits left
}

// The reference: the mean of many points of the ellipse.
TEST_F(ImageTexture, a_spot_shows_about_the_mean_of_what_it_covers) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-2, 2);
    const LinearPicture picture = random_picture(32, 32, 17);
    write_picture(path_, 32, 32, [&](long x, long y) {
        const auto& texel = picture.pixels[static_cast<std::size_t>(y * 32 + x)];
        return glm::dvec3{texel[0], texel[1], texel[2]};
    });
    FloorNode<double> node(scene());
    double error = 0;
    double spread = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const glm::dvec2 at{place(random), place(random)};
        const double diameter = std::exp2(place(random) - 3);
        glm::dvec3 sum{0.0};
        int count = 0;
        for (double x = -0.475; x < 0.5; x += 0.05) {
            for (double y = -0.475; y < 0.5; y += 0.05) {
                if (x * x + y * y > 0.25) continue;
                sum += node.color(at + glm::dvec2{x, y} * diameter, 1e-6);
                ++count;
            }
        }
        const glm::dvec3 mean = sum / static_cast<double>(count);
        error += glm::dot(node.color(at, diameter) - mean, node.color(at, diameter) - mean);
        spread += glm::dot(node.color(at, 1e-6) - mean, node.color(at, 1e-6) - mean);
    }
    // The levels are wider than the spot, so it is a blurred mean; no filter at all is `spread`.
    EXPECT_LT(error, 0.25 * spread);
}

}  // namespace
}  // namespace pxm::test
