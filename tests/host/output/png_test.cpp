// Laws of PNG files, read by OpenImageIO, which has no part in making them.
#include "host/output/png.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <thread>

#include "host/files/image_reader.hpp"
#include "host/output/image.hpp"
#include "host/output/pixel_values.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

/// Colours with runs, as pictures have them; the window need not begin at the corner.
Frame colored(const CropWindow& window, unsigned seed) {
    std::mt19937 random(seed);
    Frame frame({window.x1 + 3, window.y1 + 2}, window);
    float shade = 0;
    for (PixelRecord& pixel : frame.pixels) {
        if (random() % 4 == 0) shade = static_cast<float>(random() % 1000) / 1000;
        for (float& c : pixel.color) c = shade = 1 - shade;
    }
    return frame;
}

Frame part_of(const Frame& frame, const CropWindow& window) {
    Frame part(frame.size, window);
    for (long y = window.y0; y < window.y1; ++y)
        for (long x = window.x0; x < window.x1; ++x) part.at(x, y) = frame.at(x, y);
    return part;
}

TEST(Png, holds_the_bytes_of_the_frame) {
    const test::Folder folder;
    for (const CropWindow& window : {CropWindow{0, 0, 1, 1}, CropWindow{0, 0, 300, 200},
                                     CropWindow{5, 61, 97, 130}, CropWindow{0, 64, 3, 128}}) {
        const Frame frame = colored(window, 1);
        write_image(folder.path("a.png"), frame, {}, {});
        const LoadedImage image = read_image(folder.path("a.png"));
        ASSERT_EQ(image.width, frame.columns());
        ASSERT_EQ(image.height, frame.rows());
        ASSERT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B"}));
        EXPECT_TRUE(image.srgb);
        for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
            for (int c = 0; c < 3; ++c) {
                const float byte = image.at(i, c) * 255;
                ASSERT_EQ(std::lround(byte), srgb_byte(frame.pixels[i].color[c])) << i;
            }
        }
    }
}

TEST(Png, does_not_depend_on_the_parts_that_it_came_in) {
    const test::Folder folder;
    const CropWindow window{5, 50, 205, 211};
    const Frame frame = colored(window, 2);
    write_image(folder.path("whole.png"), frame, {}, {});
    std::mt19937 random(7);
    for (const long side : {8, 24, 64, 150}) {
        std::vector<CropWindow> parts;
        for (long y = window.y0; y < window.y1; y += side)
            for (long x = window.x0; x < window.x1; x += side)
                parts.push_back(
                    {x, y, std::min(x + side, window.x1), std::min(y + side, window.y1)});
        std::ranges::shuffle(parts, random);
        ImageWriter writer(folder.path("parts.png"), window, {}, {});
        const auto append = [&](std::size_t first) {
            for (std::size_t i = first; i < parts.size(); i += 2)
                writer.append(part_of(frame, parts[i]));
        };
        std::thread other(append, 1);
        append(0);
        other.join();
        writer.finish();
        EXPECT_TRUE(folder.read("parts.png") == folder.read("whole.png")) << side;
    }
}

TEST(Png, tells_what_made_it_and_the_time_that_it_is_told) {
    const test::Folder folder;
    write_image(folder.path("a.png"), colored({0, 0, 4, 4}, 3), {}, {});
    const std::string bytes = folder.read("a.png");
    EXPECT_NE(bytes.find("tEXtSoftware" + std::string(1, '\0') + "pxm "), std::string::npos);
    // 1970-01-01 00:00:00, the year in two bytes.
    EXPECT_NE(bytes.find(std::string("tIME\x07\xb2\x01\x01\0\0\0", 11)), std::string::npos);
    EXPECT_NE(bytes.find("sRGB"), std::string::npos);
}

}  // namespace
}  // namespace pxm::host
