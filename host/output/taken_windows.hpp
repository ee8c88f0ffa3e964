// Which parts of a window a picture has, when its render was given up.
#pragma once

#include <algorithm>
#include <mutex>
#include <vector>

#include "host/engine/frame.hpp"

namespace pxm::host {

/// Parts that do not overlap. Any thread may add.
class TakenWindows {
  public:
    void add(const CropWindow& part) {
        const std::lock_guard lock(mutex_);
        parts_.push_back(part);
        pixels_ += (part.x1 - part.x0) * (part.y1 - part.y0);
    }
    [[nodiscard]] long pixels() const { return pixels_; }

    /// Gives what is missing of a window to `take` as pixels that were missed by every ray, in
    /// stretches of a row at most. Precondition: nobody adds.
    template <class Take>
    void fill(const PixelSize& image, const CropWindow& window, const Take& take) {
        std::ranges::sort(parts_, {}, &CropWindow::y0);
        std::vector<CropWindow> in_row;
        std::size_t next = 0;
        for (long y = window.y0; y < window.y1; ++y) {
            std::erase_if(in_row, [&](const CropWindow& part) { return part.y1 <= y; });
            for (; next < parts_.size() && parts_[next].y0 <= y; ++next)
                in_row.push_back(parts_[next]);
            std::ranges::sort(in_row, {}, &CropWindow::x0);
            long x = window.x0;
            for (const CropWindow& part : in_row) {
                if (x < part.x0) take(Frame(image, {x, y, part.x0, y + 1}));
                x = part.x1;
            }
            if (x < window.x1) take(Frame(image, {x, y, window.x1, y + 1}));
        }
    }

  private:
    std::mutex mutex_;
    std::vector<CropWindow> parts_;
    long pixels_ = 0;
};

}  // namespace pxm::host
