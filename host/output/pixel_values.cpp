#include "host/output/pixel_values.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace pxm::host {

namespace {

constexpr int steps = 255;  // of a byte
constexpr std::uint32_t bits_of_one = 0x3f80'0000;
constexpr unsigned table_shift = 16;  // keeps seven bits behind the point

unsigned char rounded_byte(float linear) {
    return static_cast<unsigned char>(std::lround(srgb_from_linear(linear) * 255.0F));
}

/// The bytes of values from 0 to 1 by their first bits: where a byte begins, and which one values
/// with the same first bits have at least. A power a channel would take as long as the rays of a
/// simple picture.
class ByteTable {
  public:
    ByteTable() {
        for (std::uint32_t byte = 1; byte <= steps; ++byte) begins_[byte] = first_of(byte);
        begins_[steps + 1] = ~std::uint32_t{0};
        std::uint32_t byte = 0;
        for (std::size_t i = 0; i < least_.size(); ++i) {
            while (begins_[byte + 1] <= i << table_shift) ++byte;
            least_[i] = static_cast<unsigned char>(byte);
        }
    }

    [[nodiscard]] unsigned char of(float linear) const {
        const float inside = linear > 0 ? std::min(linear, 1.0F) : 0.0F;
        const auto bits = std::bit_cast<std::uint32_t>(inside);
        const std::uint32_t byte = least_[bits >> table_shift];
        // A byte is wider than the values that share their first bits: there is one step at most,
        // and a sum instead of a branch that nobody foresees.
        return static_cast<unsigned char>(byte + (begins_[byte + 1] <= bits ? 1U : 0U));
    }

  private:
    /// The bits of the least number that has this byte: positive numbers are in the order of
    /// theirs.
    static std::uint32_t first_of(std::uint32_t byte) {
        std::uint32_t below = 0, above = bits_of_one;  // below has less
        while (above - below > 1) {
            const std::uint32_t middle = below + (above - below) / 2;
            (rounded_byte(std::bit_cast<float>(middle)) < byte ? below : above) = middle;
        }
        return above;
    }

    std::array<std::uint32_t, steps + 2> begins_{};
    std::array<unsigned char, (bits_of_one >> table_shift) + 1> least_{};
};

const ByteTable& byte_table() {
    static const ByteTable table;
    return table;
}

void append_aov(const PixelRecord& pixel, Aov aov, float*& to) {
    const auto put = [&](auto value) { *to++ = static_cast<float>(value); };
    switch (aov) {
        case Aov::z:
            return put(pixel.z);
        case Aov::node:
            return put(pixel.node);
        case Aov::cycles:
        case Aov::neighbours:
            return put(pixel.cycles);
        case Aov::volumes:
            return put(pixel.volumes);
        case Aov::level:
            return put(pixel.level);
        case Aov::heap:
            return put(pixel.heap);
        case Aov::alpha:
            return put(pixel.alpha);
        case Aov::object:
            return put(pixel.object);
        case Aov::word:
            return put(pixel.word);
        case Aov::normal:
            to = std::copy(pixel.normal, pixel.normal + 3, to);
            return;
    }
}

}  // namespace

float srgb_from_linear(float linear) {
    const float x = std::clamp(linear, 0.0F, 1.0F);
    return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
}

unsigned char srgb_byte(float linear) { return byte_table().of(linear); }

void put_srgb_bytes(std::span<const PixelRecord> pixels, unsigned char* to) {
    const ByteTable& table = byte_table();  // asked for once: it is behind a guard
    const PixelRecord* last = nullptr;      // neighbours are often alike, as the background is
    for (const PixelRecord& pixel : pixels) {
        if (last != nullptr && std::ranges::equal(pixel.color, last->color)) {
            std::copy(to - 3, to, to);
        } else {
            for (int i = 0; i < 3; ++i) to[i] = table.of(pixel.color[i]);
        }
        to += 3;
        last = &pixel;
    }
}

void put_srgb_words(std::span<const PixelRecord> pixels, std::uint32_t* to) {
    constexpr std::uint32_t opaque = 0xFF00'0000U;
    constexpr unsigned green = 8, blue = 16;  // bits above red
    using Bits = std::array<std::uint32_t, 3>;
    const ByteTable& table = byte_table();
    Bits last{};  // black
    std::uint32_t word = opaque;
    for (const PixelRecord& pixel : pixels) {
        const auto bits = std::bit_cast<Bits>(pixel.color);
        if (bits != last) {
            word = opaque | table.of(pixel.color[0]) |
                   static_cast<std::uint32_t>(table.of(pixel.color[1])) << green |
                   static_cast<std::uint32_t>(table.of(pixel.color[2])) << blue;
            last = bits;
        }
        *to++ = word;
    }
}

// Programs that find no A take another channel for it, or the picture for transparent.
std::vector<std::string> FloatChannels::names() const {
    std::vector<std::string> names{"R", "G", "B"};
    if (opaque) names.emplace_back("A");
    for (const Aov aov : aovs) {
        for (const AovChannel& channel : channels_of(aov)) names.push_back(channel.name);
    }
    return names;
}

void put_floats(std::span<const PixelRecord> pixels, const FloatChannels& channels, float* to) {
    for (const PixelRecord& pixel : pixels) {
        to = std::copy(pixel.color, pixel.color + 3, to);
        if (channels.opaque) *to++ = 1;
        for (const Aov aov : channels.aovs) append_aov(pixel, aov, to);
    }
}

}  // namespace pxm::host
