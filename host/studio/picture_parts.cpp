#include "host/studio/picture_parts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "host/studio/canvas_pixels.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t head_words = 4;                     // before the bits of a block
constexpr std::size_t piece_bytes = 128U << 10U;          // worth the page's being woken
constexpr auto patience = std::chrono::milliseconds(50);  // that what there is waits for more

void put_short(std::string& bytes, long number) {
    bytes += static_cast<char>(static_cast<unsigned char>(number));
    bytes += static_cast<char>(static_cast<unsigned char>(number >> 8U));
}

void put_words(std::string& bytes, std::span<const std::uint32_t> words) {
    bytes.append(reinterpret_cast<const char*>(words.data()), words.size_bytes());
}

/// Two numbers of two bytes, the first one first.
std::uint32_t pair(long first, long second) {
    return static_cast<std::uint32_t>(first) | static_cast<std::uint32_t>(second) << 16U;
}

/// The colour that most of a block is likely to have: that of most of its corners.
std::uint32_t ground_of(const CanvasPixels& pixels) {
    const auto top = pixels.row(0), bottom = pixels.row(pixels.rows - 1);
    const std::array corners{top.front(), top.back(), bottom.front(), bottom.back()};
    return *std::ranges::max_element(
        corners, {}, [&](std::uint32_t color) { return std::ranges::count(corners, color); });
}

/// Of each pixel of a row a bit, whether it is of another colour than `ground`; those that are go
/// to `others`. Returns the end of these. There is no branch in it, as nobody foresees it.
std::uint32_t* part_row(std::span<const std::uint32_t> row, std::uint32_t ground,
                        std::uint32_t* bits, std::uint32_t* others) {
    for (std::size_t begin = 0; begin < row.size(); begin += 32) {
        const auto word = row.subspan(begin, std::min<std::size_t>(32, row.size() - begin));
        std::uint32_t mask = 0;
        for (std::size_t i = 0; i < word.size(); ++i) {
            const bool other = word[i] != ground;
            mask |= static_cast<std::uint32_t>(other) << i;
            *others = word[i];
            others += other ? 1 : 0;
        }
        *bits++ = mask;
    }
    return others;
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
    const std::uint32_t ground = ground_of(pixels);
    const auto row_words = static_cast<std::size_t>(pixels.columns + 31) / 32;
    const std::size_t begin = head_words + row_words * static_cast<std::size_t>(pixels.rows);
    // One more, as a row's last pixel is put behind the others before it is known to be the ground.
    std::vector<std::uint32_t> block(begin + pixels.rgba.size() + 1);
    std::uint32_t* bits = block.data() + head_words;
    std::uint32_t* others = block.data() + begin;
    for (long y = 0; y < pixels.rows; ++y, bits += row_words)
        others = part_row(pixels.row(y), ground, bits, others);
    const auto end = static_cast<std::size_t>(others - block.data());
    block[0] = pair(part.crop.x0 - window_.x0, part.crop.y0 - window_.y0);
    block[1] = pair(pixels.columns, pixels.rows);
    block[2] = ground;
    block[3] = static_cast<std::uint32_t>(end - begin);
    block.resize(end);
    if (of_machine_) {
        const std::vector<std::uint32_t> cycles = canvas_cycles(part);
        block.insert(block.end(), cycles.begin(), cycles.end());
    }
    add(block);
}

void PictureParts::add(std::span<const std::uint32_t> block) {
    const std::lock_guard lock(mutex_);
    put_words(waiting_, block);
    const auto now = Clock::now();
    if (waiting_.size() < piece_bytes && now - sent_ < patience) return;
    sent_ = now;
    send_(std::exchange(waiting_, {}));
    waiting_.reserve(piece_bytes + piece_bytes / 4);
}

void PictureParts::end(const std::string& json) {
    put_words(waiting_, std::array<std::uint32_t, head_words>{
                            0, 0, 0, static_cast<std::uint32_t>(json.size())});
    waiting_ += json;
    send_(std::exchange(waiting_, {}));
}

}  // namespace pxm::host
