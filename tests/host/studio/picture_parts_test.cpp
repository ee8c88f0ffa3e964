// The laws of host/studio/picture_parts.hpp: the blocks, read by five lines of a model, are the
// picture, whatever is of one colour in them.
#include "host/studio/picture_parts.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/output/pixel_values.hpp"
#include "host/studio/picture.hpp"
#include "tests/support/command.hpp"

namespace pxm::host {
namespace {

struct ReadPicture {
    long columns = 0;
    std::vector<std::string> rgba;  // of each pixel, as often as it was sent
    std::vector<std::uint64_t> cycles;
    std::size_t blocks = 0;
    std::string json;
};

std::uint64_t number_at(const std::string& bytes, std::size_t at, int count) {
    std::uint64_t number = 0;
    for (int i = count - 1; i >= 0; --i)
        number =
            number << 8U | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i)));
    return number;
}

/// What the page does with it.
ReadPicture read_parts(const std::string& bytes) {
    ReadPicture picture;
    picture.columns = static_cast<long>(number_at(bytes, 0, 2));
    const bool of_machine = number_at(bytes, 4, 2) == 1;
    const auto width = static_cast<std::size_t>(picture.columns);
    picture.rgba.resize(width * number_at(bytes, 2, 2));
    if (of_machine) picture.cycles.resize(picture.rgba.size());
    std::size_t at = 8;
    for (; number_at(bytes, at + 4, 2) > 0; ++picture.blocks) {
        std::size_t of[4];
        for (std::size_t i = 0; i < 4; ++i) of[i] = number_at(bytes, at + 2 * i, 2);
        const std::string color = bytes.substr(at + 8, 4);
        const std::size_t others = number_at(bytes, at + 12, 4);
        std::size_t row_bits = at + 16, other = row_bits + of[3] * ((of[2] + 31) / 32) * 4;
        at = other + 4 * others;
        for (std::size_t y = 0; y < of[3]; ++y, row_bits += (of[2] + 31) / 32 * 4) {
            for (std::size_t x = 0; x < of[2]; ++x) {
                const bool is_other = number_at(bytes, row_bits + x / 8, 1) >> x % 8 & 1U;
                picture.rgba.at((of[1] + y) * width + of[0] + x) +=
                    is_other ? bytes.substr(other, 4) : color;
                other += is_other ? 4 : 0;
            }
        }
        EXPECT_EQ(other, at);
        for (std::size_t y = of[1]; of_machine && y < of[1] + of[3]; ++y)
            for (std::size_t x = of[0]; x < of[0] + of[2]; ++x, at += 4)
                picture.cycles.at(y * width + x) = number_at(bytes, at, 4);
    }
    picture.json = bytes.substr(at + 16);
    EXPECT_EQ(number_at(bytes, at + 12, 4), picture.json.size());
    return picture;
}

AskedPicture asked(const std::string& text, long columns, long rows) {
    AskedPicture picture;
    picture.scene.name = "a.pxm";
    picture.scene.text = text;
    picture.size = {columns, rows};
    return picture;
}

struct Sent {
    ReadPicture picture;
    std::size_t bytes = 0;
};

Sent sent(const AskedPicture& wanted, int threads) {
    std::string bytes;
    std::atomic<bool> stop = false;
    PictureParts parts([&](const std::string& piece) { bytes += piece; },
                       wanted.machine != nullptr);
    EXPECT_FALSE(parts.has_begun());
    (void)render_asked(wanted, threads, stop, {}, parts);
    EXPECT_TRUE(parts.has_begun());
    parts.end("{\"last\":1}");
    return {read_parts(bytes), bytes.size()};
}

void expect_picture(const ReadPicture& read, const AskedPicture& wanted) {
    const RenderResult whole = render(request_of(wanted, 1), {});
    ASSERT_EQ(read.rgba.size(), whole.frame.pixels.size());
    for (std::size_t i = 0; i < read.rgba.size(); ++i) {
        unsigned char rgb[3];
        put_srgb_bytes(std::span(whole.frame.pixels).subspan(i, 1), rgb);
        ASSERT_EQ(read.rgba[i], std::string(rgb, rgb + 3) + "\xFF") << "pixel " << i;
    }
}

TEST(PictureParts, are_the_picture) {
    for (const int threads : {1, 3}) {
        AskedPicture wanted = asked(test::tetra_scene, 190, 150);
        wanted.settings = {{"camera.zoom", "3"}};
        const Sent found = sent(wanted, threads);
        EXPECT_GT(found.picture.blocks, 5U);
        expect_picture(found.picture, wanted);
        EXPECT_EQ(found.picture.json, "{\"last\":1}");
    }
}

TEST(PictureParts, say_little_of_what_is_of_one_colour) {
    AskedPicture wanted = asked(test::tetra_scene, 640, 480);
    wanted.settings = {{"camera.zoom", "0.2"}};
    const Sent found = sent(wanted, 1);
    expect_picture(found.picture, wanted);
    EXPECT_LT(found.bytes, 640U * 480 * 4 / 10);
}

TEST(PictureParts, have_the_machines_cycles) {
    AskedPicture wanted = asked(test::tetra_scene, 24, 16);
    wanted.machine = find_model("964dX");
    const Sent found = sent(wanted, 1);
    expect_picture(found.picture, wanted);
    const RenderResult whole = render(request_of(wanted, 1), {});
    for (std::size_t i = 0; i < whole.frame.pixels.size(); ++i)
        ASSERT_EQ(found.picture.cycles.at(i), whole.frame.pixels[i].cycles) << "pixel " << i;
}

TEST(PictureParts, are_the_picture_with_more_samples) {
    AskedPicture wanted = asked(test::tetra_scene, 40, 30);
    wanted.settings = {{"render.samples", "4"}};
    const Sent found = sent(wanted, 1);
    expect_picture(found.picture, wanted);
}

}  // namespace
}  // namespace pxm::host
