// Laws of rows that are put together from blocks.
#include "host/output/row_bands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace pxm::host {
namespace {

TEST(InOrder, hands_on_all_things_by_their_numbers_whatever_order_they_come_in) {
    std::mt19937 random(11);
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<long> numbers(static_cast<std::size_t>(random() % 40));
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<long>(i);
        std::vector<long> expected = numbers;
        std::ranges::shuffle(numbers, random);
        InOrder<long> in_order;
        std::vector<long> got;
        for (const long number : numbers)
            in_order.add(number, number, [&](long thing) { got.push_back(thing); });
        EXPECT_EQ(got, expected);
    }
}

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
