// A picture's rows, put together from the blocks that threads render: bands of rows that begin at
// multiples of a fixed number of rows of the image, so that a file does not depend on how its rows
// came about.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "host/engine/frame.hpp"

namespace pxm::host {

/// Rows of every band but the first and the last of a window, which its edges may cut.
inline constexpr long band_rows = 64;

struct RowBand {
    long index = 0;      // from 0 at the top
    long first_row = 0;  // counted from the window's top
    long rows = 0;
    std::vector<unsigned char> bytes;
};

/// Any thread may add blocks.
class RowBands {
  public:
    RowBands(const CropWindow& window, std::size_t pixel_bytes)
        : window_(window), pixel_bytes_(pixel_bytes) {}

    [[nodiscard]] std::size_t row_bytes() const {
        return pixel_bytes_ * static_cast<std::size_t>(window_.x1 - window_.x0);
    }

    /// `put(pixels, to)` writes the bytes of some pixels of a row; `whole(band)` takes a band that
    /// the block was the last one of.
    template <class Put, class Whole>
    void add(const Frame& block, const Put& put, const Whole& whole) {
        for (long top = block.crop.y0; top < block.crop.y1;) {
            const long bottom = std::min(block.crop.y1, (top / band_rows + 1) * band_rows);
            const std::shared_ptr<Open> band = open(top / band_rows);
            for (long y = top; y < bottom; ++y) {
                const auto at = static_cast<std::size_t>(y - window_.y0 - band->band.first_row);
                put(std::span(&block.at(block.crop.x0, y),
                              static_cast<std::size_t>(block.columns())),
                    band->band.bytes.data() + at * row_bytes() +
                        static_cast<std::size_t>(block.crop.x0 - window_.x0) * pixel_bytes_);
            }
            const long put_now = (bottom - top) * block.columns();
            if (band->missing.fetch_sub(put_now) == put_now) whole(taken(top / band_rows));
            top = bottom;
        }
    }

  private:
    struct Open {
        RowBand band;
        std::atomic<long> missing = 0;  // pixels
    };

    std::shared_ptr<Open> open(long number);
    RowBand taken(long number);

    CropWindow window_;
    std::size_t pixel_bytes_;
    std::mutex mutex_;
    std::map<long, std::shared_ptr<Open>> open_;  // by the number of the band in the image
};

}  // namespace pxm::host
