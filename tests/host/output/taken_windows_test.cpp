// Laws of what is known of a picture that was given up: what was taken and what fills the rest
// cover every pixel once.
#include "host/output/taken_windows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace pxm::test {
namespace {

using host::CropWindow;
using host::Frame;
using host::PixelSize;

/// How often each pixel of the window is in a part.
std::vector<int> counts_of(const CropWindow& window, const std::vector<CropWindow>& parts) {
    const long columns = window.x1 - window.x0;
    std::vector<int> counts(static_cast<std::size_t>(columns * (window.y1 - window.y0)));
    for (const CropWindow& part : parts)
        for (long y = part.y0; y < part.y1; ++y)
            for (long x = part.x0; x < part.x1; ++x)
                ++counts.at(static_cast<std::size_t>((y - window.y0) * columns + x - window.x0));
    return counts;
}

TEST(TakenWindows, what_was_taken_and_what_fills_it_cover_each_pixel_once) {
    const PixelSize image{50, 40};
    const CropWindow window{3, 5, 47, 38};
    std::mt19937 random(1);
    for (int i = 0; i < 50; ++i) {
        host::TakenWindows taken;
        std::vector<CropWindow> parts;
        long pixels = 0;
        for (long y = window.y0; y < window.y1; y += 8) {
            for (long x = window.x0; x < window.x1; x += 8) {
                if (random() % 3 == 0) continue;
                parts.push_back({x, y, std::min(x + 8, window.x1), std::min(y + 8, window.y1)});
            }
        }
        std::shuffle(parts.begin(), parts.end(), random);
        for (const CropWindow& part : parts) {
            taken.add(part);
            pixels += (part.x1 - part.x0) * (part.y1 - part.y0);
        }
        EXPECT_EQ(taken.pixels(), pixels);
        taken.fill(image, window, [&](const Frame& black) {
            ASSERT_EQ(black.size, image);
            for (const host::PixelRecord& pixel : black.pixels) ASSERT_EQ(pixel.object, -1);
            parts.push_back(black.crop);
        });
        for (const int count : counts_of(window, parts)) ASSERT_EQ(count, 1);
    }
}

TEST(TakenWindows, of_nothing_all_is_filled_and_of_all_nothing) {
    const PixelSize image{9, 7};
    const CropWindow window{0, 0, 9, 7};
    host::TakenWindows none;
    long filled = 0;
    none.fill(image, window, [&](const Frame& black) { filled += black.columns() * black.rows(); });
    EXPECT_EQ(filled, 63);
    host::TakenWindows all;
    all.add(window);
    all.fill(image, window, [&](const Frame&) { FAIL(); });
}

}  // namespace
}  // namespace pxm::test
