// Laws of what a file holds of a pixel.
#include "host/output/pixel_values.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace pxm::host {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(Srgb, the_curve_is_that_of_IEC_61966) {
    EXPECT_EQ(srgb_from_linear(0), 0);
    EXPECT_NEAR(srgb_from_linear(1), 1, 1e-6);
    EXPECT_NEAR(srgb_from_linear(0.002F), 12.92 * 0.002, 1e-7);
    EXPECT_NEAR(srgb_from_linear(0.18F), 0.461356, 1e-6);
    EXPECT_NEAR(srgb_from_linear(0.5F), 0.735357, 1e-6);
    constexpr float knee = 0.0031308F;
    EXPECT_NEAR(srgb_from_linear(std::nextafter(knee, 1.0F)), srgb_from_linear(knee), 1e-6);
}

TEST(Srgb, the_curve_rises_and_clips_what_no_screen_shows) {
    for (int i = 0; i < 1000; ++i) {
        const auto x = static_cast<float>(i);
        EXPECT_LT(srgb_from_linear(x / 1000), srgb_from_linear((x + 1) / 1000));
    }
    EXPECT_EQ(srgb_from_linear(-3), 0);
    EXPECT_EQ(srgb_from_linear(7), srgb_from_linear(1));
    EXPECT_EQ(srgb_from_linear(infinity), srgb_from_linear(1));
}

/// As the sRGB curve says.
int byte_by_the_curve(float linear) {
    return static_cast<int>(std::lround(srgb_from_linear(linear) * 255.0F));
}

TEST(Srgb, a_byte_is_the_rounded_value_of_the_curve) {
    std::mt19937 random(3);
    for (int i = 0; i < 1'000'000; ++i) {
        // Evenly over the numbers from 0 to 1, and over their values.
        const float x =
            i % 2 == 0 ? std::bit_cast<float>(static_cast<std::uint32_t>(random() % 0x3f80'0001))
                       : static_cast<float>(random()) / 4294967296.0F;
        ASSERT_EQ(int{srgb_byte(x)}, byte_by_the_curve(x)) << x;
    }
}

TEST(Srgb, so_it_is_for_all_numbers_beside_a_step) {
    int steps = 0;
    for (std::uint32_t bits = 1; bits < 0x3f80'0000; bits += 997) {
        const float a = std::bit_cast<float>(bits), b = std::bit_cast<float>(bits + 997);
        if (byte_by_the_curve(a) == byte_by_the_curve(b)) continue;
        ++steps;
        for (std::uint32_t k = 0; k <= 997; ++k) {
            const float x = std::bit_cast<float>(bits + k);
            ASSERT_EQ(int{srgb_byte(x)}, byte_by_the_curve(x)) << x;
        }
    }
    EXPECT_EQ(steps, 255);
}

TEST(Srgb, a_byte_of_what_no_screen_shows_is_the_nearest) {
    EXPECT_EQ(srgb_byte(-1), 0);
    EXPECT_EQ(srgb_byte(0), 0);
    EXPECT_EQ(srgb_byte(1), 255);
    EXPECT_EQ(srgb_byte(infinity), 255);
    EXPECT_EQ(srgb_byte(std::numeric_limits<float>::quiet_NaN()), 0);
}

TEST(Srgb, bytes_of_pixels_are_those_of_each_value_whatever_stands_before) {
    std::mt19937 random(5);
    const float values[] = {0,    -0.0F, 0.2F, std::nextafter(0.2F, 1.0F),
                            0.9F, 7,     -1,   std::numeric_limits<float>::quiet_NaN()};
    std::vector<PixelRecord> pixels(10'000);
    for (PixelRecord& pixel : pixels)
        for (float& part : pixel.color) part = values[random() % (random() % 4 == 0 ? 8 : 2)];
    std::vector<unsigned char> bytes(3 * pixels.size());
    put_srgb_bytes(pixels, bytes.data());
    for (std::size_t i = 0; i < bytes.size(); ++i)
        ASSERT_EQ(int{bytes[i]}, int{srgb_byte(pixels[i / 3].color[i % 3])}) << i;
    std::vector<std::uint32_t> words(pixels.size());
    put_srgb_words(pixels, words.data());
    for (std::size_t i = 0; i < words.size(); ++i) {
        const unsigned char* rgb = bytes.data() + 3 * i;
        ASSERT_EQ(words[i], 0xFF00'0000U | static_cast<std::uint32_t>(rgb[2]) << 16U |
                                static_cast<std::uint32_t>(rgb[1]) << 8U | rgb[0])
            << i;
    }
}

}  // namespace
}  // namespace pxm::host
