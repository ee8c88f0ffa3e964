// Hashes of 64 bits: enough to tell apart what nobody forged. FNV-1a for units one by one, and one
// that takes eight bytes at a time, for so many bytes that the first would be felt.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace pxm::host {

class Digest {
  public:
    /// A byte, or another small number that stands for one unit of what is hashed.
    constexpr void add(std::uint64_t unit) { value_ = (value_ ^ unit) * 0x100'0000'01b3; }
    template <class Unit>
    constexpr void add_all(std::span<const Unit> units) {
        for (const Unit unit : units) add(unit);
    }
    [[nodiscard]] constexpr std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf2'9ce4'8422'2325;
};

/// Of many bytes. Each step is one-to-one in the sum and in the word: a changed word always shows.
[[nodiscard]] inline std::uint64_t digest_of(std::string_view bytes) {
    constexpr std::uint64_t factor = 0x9e37'79b9'7f4a'7c15;  // 2^64 over the golden ratio, odd
    std::uint64_t sum = bytes.size() * factor;
    while (!bytes.empty()) {
        std::uint64_t word = 0;
        const std::size_t taken = bytes.size() < sizeof word ? bytes.size() : sizeof word;
        std::memcpy(&word, bytes.data(), taken);
        sum = (sum ^ word) * factor;
        sum ^= sum >> 29U;  // so that high bits reach low ones
        bytes.remove_prefix(taken);
    }
    return sum;
}

}  // namespace pxm::host
