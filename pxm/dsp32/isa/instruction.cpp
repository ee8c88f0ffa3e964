#include "pxm/dsp32/isa/instruction.hpp"

#include <algorithm>

namespace pxm::dsp32::isa {

namespace {

constexpr Word field_mask(const Field& field) { return (Word{1} << field.bits) - 1; }

std::span<const Field> fields_of(const Format& format) {
    return {format.fields.data(), static_cast<std::size_t>(format.field_count)};
}

bool matches(const Format& format, Word word, Dialect dialect) {
    if (format.since > dialect) return false;
    if ((word & format.fixed_mask) != format.fixed_bits) return false;
    return std::ranges::all_of(fields_of(format), [&](const Field& field) {
        return field_allows(field.letter, word >> field.low_bit & field_mask(field), dialect);
    });
}

bool has_field(const Format& format, char letter) {
    return std::ranges::any_of(fields_of(format),
                               [&](const Field& field) { return field.letter == letter; });
}

}  // namespace

bool Instruction::has(char letter) const noexcept { return has_field(*format, letter); }

unsigned Instruction::value(char letter) const noexcept {
    for (std::size_t i = 0; i < static_cast<std::size_t>(format->field_count); ++i)
        if (format->fields[i].letter == letter) return values[i];
    return 0;
}

std::optional<Instruction> decode(Word word, Dialect dialect) noexcept {
    for (const Format& format : formats()) {
        if (!matches(format, word, dialect)) continue;
        Instruction instruction{&format, {}};
        std::size_t i = 0;
        for (const Field& field : fields_of(format)) {
            instruction.values[i++] =
                static_cast<std::uint16_t>(word >> field.low_bit & field_mask(field));
        }
        return instruction;
    }
    return std::nullopt;
}

Word encode(const Instruction& instruction) noexcept {
    Word word = instruction.format->fixed_bits;
    std::size_t i = 0;
    for (const Field& field : fields_of(*instruction.format)) {
        word |= (instruction.values[i++] & field_mask(field)) << field.low_bit;
    }
    return word;
}

std::optional<Word> word_of_fields(Operation operation, bool wide, Dialect dialect,
                                   FieldValues values) noexcept {
    for (const Format& format : formats()) {
        if (format.operation != operation || format.wide != wide) continue;
        if (!std::ranges::all_of(values,
                                 [&](const auto& value) { return has_field(format, value.first); }))
            continue;
        Word word = format.fixed_bits;
        for (const Field& field : fields_of(format)) {
            for (const auto& [letter, value] : values)
                if (letter == field.letter) word |= (value & field_mask(field)) << field.low_bit;
        }
        if (!matches(format, word, dialect)) return std::nullopt;
        return word;
    }
    return std::nullopt;
}

}  // namespace pxm::dsp32::isa
