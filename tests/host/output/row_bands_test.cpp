// Laws of rows that are put together from blocks.
#include "host/output/row_bands.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace pxm::host {
namespace {

TEST(RowBands, are_cut_at_fixed_rows_of_the_image_and_whole_when_their_last_pixel_comes) {
    const CropWindow window{3, 60, 13, 200};
    RowBands bands(window, 1);
    std::vector<RowBand> got;
    for (long x = window.x0; x < window.x1; ++x) {
        Frame column({20, 300}, {x, window.y0, x + 1, window.y1});
        const auto put = [&](std::span<const PixelRecord> pixels, unsigned char* to) {
            ASSERT_EQ(pixels.size(), 1U);
            *to = static_cast<unsigned char>(x);
        };
        EXPECT_TRUE(got.empty()) << x;
        bands.add(column, put, [&](RowBand band) { got.push_back(std::move(band)); });
    }
    ASSERT_EQ(got.size(), 4U);
    const long rows[] = {4, 64, 64, 8};
    long first = 0;
    for (std::size_t i = 0; i < got.size(); ++i) {
        EXPECT_EQ(got[i].index, static_cast<long>(i));
        EXPECT_EQ(got[i].first_row, first);
        EXPECT_EQ(got[i].rows, rows[i]);
        ASSERT_EQ(got[i].bytes.size(), static_cast<std::size_t>(rows[i] * 10));
        for (std::size_t k = 0; k < got[i].bytes.size(); ++k)
            ASSERT_EQ(got[i].bytes[k], 3 + k % 10);
        first += rows[i];
    }
}

}  // namespace
}  // namespace pxm::host
