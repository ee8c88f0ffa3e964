// An instruction: a format of the table and what its fields hold. Encoding and decoding are the
// table's, so each undoes the other.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <utility>

#include "pxm/dsp32/isa/format.hpp"

namespace pxm::dsp32::isa {

/// The instruction in which nothing happens: a branch on `false`.
inline constexpr Word nop = 0;

struct Instruction {                                  // a word, taken apart
    const Format* format = nullptr;                   // null: it is no instruction
    std::array<std::uint16_t, most_fields> values{};  // in the order of the format's fields

    /// Precondition: it is one.
    [[nodiscard]] Operation operation() const noexcept { return format->operation; }
    [[nodiscard]] bool has(char letter) const noexcept;  // whether its format has such a field
    /// What the field of that letter holds; 0 if the format has none.
    [[nodiscard]] unsigned value(char letter) const noexcept;
    /// The field of 16 bits as a signed number.
    [[nodiscard]] int constant() const noexcept { return static_cast<std::int16_t>(value('i')); }
    /// The fields of 8 and 16 bits together.
    [[nodiscard]] std::uint32_t long_constant() const noexcept {
        return (value('H') << 16U) | value('i');
    }
};

/// The word's instruction; none if the dialect does not have the word.
[[nodiscard]] std::optional<Instruction> decode(Word word, Dialect dialect) noexcept;

/// The word of an instruction.
[[nodiscard]] Word encode(const Instruction& instruction) noexcept;

/// Fields by their letters, and what stands in them.
using FieldValues = std::initializer_list<std::pair<char, unsigned>>;

/// The word of an operation whose fields hold these values and 0 elsewhere: the format is the first
/// that has all of them. None if the dialect has no such format, or a field may not hold its value.
[[nodiscard]] std::optional<Word> word_of_fields(Operation operation, bool wide, Dialect dialect,
                                                 FieldValues values) noexcept;

}  // namespace pxm::dsp32::isa
