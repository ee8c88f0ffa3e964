#include "host/studio/picture_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "host/studio/canvas_pixels.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t head_bytes = 20;                    // before the pixels of a block
constexpr std::size_t piece_bytes = 128U << 10U;          // worth the page's being woken
constexpr auto patience = std::chrono::milliseconds(50);  // that what there is waits for more

void put_short(std::string& bytes, long number) {
    bytes += static_cast<char>(static_cast<unsigned char>(number));
    bytes += static_cast<char>(static_cast<unsigned char>(number >> 8U));
}

/// Columns x0 to x1 and rows y0 to y1 of a block.
struct Rectangle {
    long x0, y0, x1, y1;
};

/// The least rectangle of a block that holds all pixels which are not as the first one.
Rectangle uneven_part(const CanvasPixels& pixels) {
    const auto [columns, rows] = std::pair(pixels.columns, pixels.rows);
    Rectangle part{columns, rows, 0, 0};
    const std::uint32_t first = pixels.rgba.front();
    for (long y = 0; y < rows; ++y) {
        const auto row = pixels.row(y);
        const auto other = [&](std::uint32_t pixel) { return pixel != first; };
        const auto from = std::ranges::find_if(row, other);
        if (from == row.end()) continue;
        const auto to = std::find_if(row.rbegin(), row.rend(), other);
        part.x0 = std::min(part.x0, static_cast<long>(from - row.begin()));
        part.x1 = std::max(part.x1, static_cast<long>(row.rend() - to));
        part.y0 = std::min(part.y0, y);
        part.y1 = y + 1;
    }
    return part.x0 < part.x1 ? part : Rectangle{0, 0, 0, 0};
}

void put_pixels(std::string& bytes, std::span<const std::uint32_t> pixels) {
    bytes.append(reinterpret_cast<const char*>(pixels.data()), pixels.size_bytes());
}

}  // namespace

void PictureParts::begin(const RenderResult& known) {
    window_ = known.window;
    begun_ = true;
    sent_ = Clock::now();
    put_short(waiting_, window_.x1 - window_.x0);
    put_short(waiting_, window_.y1 - window_.y0);
    put_short(waiting_, of_machine_ ? 1 : 0);
    put_short(waiting_, 0);
}

void PictureParts::take(const Frame& part) {
    const CanvasPixels pixels = canvas_pixels(part);
    const Rectangle uneven = uneven_part(pixels);
    const long left = part.crop.x0 - window_.x0, top = part.crop.y0 - window_.y0;
    std::string bytes;
    bytes.reserve(head_bytes +
                  sizeof(std::uint32_t) * pixels.rgba.size() * (of_machine_ ? 2U : 1U));
    for (const long number : {left, top, pixels.columns, pixels.rows, left + uneven.x0,
                              top + uneven.y0, uneven.x1 - uneven.x0, uneven.y1 - uneven.y0})
        put_short(bytes, number);
    put_pixels(bytes, std::span(pixels.rgba).first(1));
    for (long y = uneven.y0; y < uneven.y1; ++y)
        put_pixels(bytes, pixels.row(y).subspan(static_cast<std::size_t>(uneven.x0),
                                                static_cast<std::size_t>(uneven.x1 - uneven.x0)));
    if (of_machine_) put_pixels(bytes, canvas_cycles(part));
    add(bytes);
}

void PictureParts::add(const std::string& bytes) {
    const std::lock_guard lock(mutex_);
    waiting_ += bytes;
    const auto now = Clock::now();
    if (waiting_.size() < piece_bytes && now - sent_ < patience) return;
    sent_ = now;
    send_(std::exchange(waiting_, {}));
    waiting_.reserve(piece_bytes + piece_bytes / 4);
}

void PictureParts::end(const std::string& json) {
    waiting_.append(head_bytes, '\0');
    waiting_ += json;
    send_(std::exchange(waiting_, {}));
}

}  // namespace pxm::host
