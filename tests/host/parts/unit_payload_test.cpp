// Laws of a unit as bytes: what is kept comes back, to the bit.
#include "host/parts/unit_payload.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>

namespace pxm::host {
namespace {

/// Pixels with runs of equal ones, and values of every kind: zeros of both signs, no numbers.
std::vector<PixelRecord> some_pixels(std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<PixelRecord> pixels(count);
    PixelRecord pixel;
    for (PixelRecord& one : pixels) {
        if (random() % 3 == 0) {
            for (float& part : pixel.color)
                part = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            pixel.z = random() % 2 == 0 ? -0.0F : 1.5F;
            pixel.cycles = std::uint64_t{random()} << 20U | random() % 1024;
            pixel.node = static_cast<std::uint16_t>(random());
            pixel.level = static_cast<std::int32_t>(random() % 9) - 1;
            pixel.object = static_cast<std::int32_t>(random());
            pixel.word = static_cast<std::uint32_t>(random());
            pixel.volumes = static_cast<std::uint32_t>(random());
            pixel.heap = static_cast<std::uint32_t>(random());
            pixel.alpha = 0.25F;
            pixel.normal[random() % 3] = 0.5F;
        }
        one = pixel;
    }
    return pixels;
}

TEST(UnitPayload, gives_back_every_bit_of_every_channel) {
    for (const std::size_t count : {0U, 1U, 3U, 64U, 1000U, 4096U}) {
        std::vector<PixelRecord> pixels = some_pixels(count, 7 + static_cast<std::uint32_t>(count));
        FinishedUnit unit{17, pixels, {}, nullptr};
        unit.rays.volumes_tested = 0xffff'ffff'ffff;
        AlarmSums alarms;
        alarms.nearest = 0.125;
        alarms.of_misses[3] = 12;
        const auto back = unit_of_payload(payload_of(unit, alarms, all_aovs()), count, all_aovs());
        ASSERT_TRUE(back) << count;
        EXPECT_EQ(back->rays.volumes_tested, unit.rays.volumes_tested);
        EXPECT_EQ(back->alarms.nearest, 0.125);
        EXPECT_EQ(back->alarms.of_misses[3], 12U);
        EXPECT_FALSE(back->node);
        ASSERT_EQ(back->pixels.size(), count);
        for (std::size_t i = 0; i < count; ++i)
            EXPECT_EQ(std::memcmp(&back->pixels[i], &pixels[i], sizeof(PixelRecord)), 0) << i;
    }
}

TEST(UnitPayload, keeps_what_was_asked_for) {
    std::vector<PixelRecord> pixels = some_pixels(64, 1);
    const std::vector<Aov> channels{Aov::word};
    const auto back =
        unit_of_payload(payload_of({0, pixels, {}, nullptr}, {}, channels), 64, channels);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->pixels[63].word, pixels[63].word);
    EXPECT_TRUE(std::isinf(back->pixels[63].z)) << "as of a miss";
    EXPECT_EQ(back->pixels[63].object, -1);
}

TEST(UnitPayload, of_one_colour_takes_no_room) {
    std::vector<PixelRecord> pixels(4096);
    const std::string bytes = payload_of({0, pixels, {}, nullptr}, {}, {Aov::z, Aov::word});
    EXPECT_LT(bytes.size(), 400U);
}

TEST(UnitPayload, that_is_cut_or_of_other_channels_is_none) {
    std::vector<PixelRecord> pixels = some_pixels(64, 3);
    const std::string bytes = payload_of({0, pixels, {}, nullptr}, {}, {Aov::z});
    for (std::size_t size = 0; size < bytes.size(); size += 5)
        EXPECT_FALSE(unit_of_payload(bytes.substr(0, size), 64, {Aov::z})) << size;
    EXPECT_FALSE(unit_of_payload(bytes + "x", 64, {Aov::z}));
    EXPECT_FALSE(unit_of_payload(bytes, 63, {Aov::z}));
    EXPECT_FALSE(unit_of_payload(bytes, 64, {Aov::z, Aov::word}));
}

}  // namespace
}  // namespace pxm::host
