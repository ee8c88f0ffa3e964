// A cell's word: the numbers of the maps that lead to it, outermost first, packed so that comparing
// words as unsigned integers compares them lexicographically.
// Node code: no allocation, no exceptions.
#pragma once

#include <array>
#include <cstdint>

namespace pxm::kernels {

inline constexpr int word_capacity = 50;  // 32-bit words; makes a float cell 316 bytes

/// Symbols of `bits` bits each, first symbol in the highest bits; a symbol never straddles two
/// words. Words beyond the last used one are not kept clean.
struct CellWord {
    std::array<std::uint32_t, word_capacity> packed;  // the symbols

    /// Symbols of so many bits.
    [[nodiscard]] static constexpr std::uint32_t per_word(std::uint32_t bits) noexcept {
        return 32 / bits;
    }
    /// Most symbols of so many bits that a word holds.
    [[nodiscard]] static constexpr std::uint32_t longest(std::uint32_t bits) noexcept {
        return word_capacity * per_word(bits);
    }
    /// Words in use for `length` symbols.
    [[nodiscard]] static constexpr std::uint32_t used(std::uint32_t length,
                                                      std::uint32_t bits) noexcept {
        return (length + per_word(bits) - 1) / per_word(bits);
    }

    /// Sets symbol number `place`; all later places of the same 32-bit word become zero.
    void set(std::uint32_t place, std::uint32_t bits, std::uint32_t symbol) noexcept {
        const std::uint32_t slot = place % per_word(bits);
        std::uint32_t& target = packed[place / per_word(bits)];
        const std::uint32_t shift = 32 - bits * (slot + 1);
        const std::uint32_t before = slot == 0 ? 0 : target >> (shift + bits) << (shift + bits);
        target = before | symbol << shift;
    }
    /// Symbol number `place`.
    [[nodiscard]] std::uint32_t get(std::uint32_t place, std::uint32_t bits) const noexcept {
        const std::uint32_t shift = 32 - bits * (place % per_word(bits) + 1);
        return packed[place / per_word(bits)] >> shift & ((1U << bits) - 1);
    }
};

/// Whether word a of length `a_used` words comes before b: lexicographic, a prefix before its
/// extensions. `a_length`, `b_length` in symbols.
[[nodiscard]] inline bool word_before(const CellWord& a, std::uint32_t a_length, const CellWord& b,
                                      std::uint32_t b_length, std::uint32_t bits) noexcept {
    const std::uint32_t shorter = a_length < b_length ? a_length : b_length;
    const std::uint32_t used = CellWord::used(shorter, bits);
    for (std::uint32_t i = 0; i < used; ++i) {
        if (a.packed[i] != b.packed[i]) return a.packed[i] < b.packed[i];
    }
    return a_length < b_length;
}

}  // namespace pxm::kernels
