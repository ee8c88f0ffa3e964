// A picture as the page gets it: block by block as the threads that render have them, so that most
// of it is there when the last ray has ended. Little needs to be said of a block whose pixels are
// alike.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <utility>

#include "host/render/render.hpp"

namespace pxm::host {

/// What is sent, numbers of two bytes but where it is said, lowest first:
///   columns, rows, 1 of a machine and 0 else, 0;
///   of each block: left, top, columns, rows; the colour of most of it, and how many pixels are of
///   another one, in four bytes each; of each row a bit a pixel, set for those, in words of four
///   bytes, lowest bit first; the colours of those: red, green, blue, 255; of a machine every
///   pixel's cycles, in four bytes;
///   a block of no pixels, with a number of bytes instead of theirs; so many of JSON, which is what
///   is known at the end.
class PictureParts : public PictureTaker {
  public:
    /// `send` is called by any thread, one at a time.
    PictureParts(std::function<void(std::string)> send, bool of_machine)
        : send_(std::move(send)), of_machine_(of_machine) {}

    void begin(const RenderResult& known) override;
    void take(const Frame& part) override;
    /// Precondition: it has begun, and nobody takes any more.
    void end(const std::string& json);
    [[nodiscard]] bool has_begun() const { return begun_; }

  private:
    using Clock = std::chrono::steady_clock;
    void add(std::span<const std::uint32_t> block);

    std::function<void(std::string)> send_;
    bool of_machine_;
    bool begun_ = false;
    CropWindow window_;
    std::mutex mutex_;
    std::string waiting_;  // that is sent together
    Clock::time_point sent_;
};

}  // namespace pxm::host
