// The first pass: what every line of a program is, where it lies, and what the names mean.
#pragma once

#include <map>
#include <string>

#include "pxm/dsp32/assembler/cursor.hpp"
#include "pxm/dsp32/isa/format.hpp"

namespace pxm::dsp32::assembler {

enum class Section : std::uint8_t { text, data, none };
enum class ItemKind : std::uint8_t { instruction, reals, halves, words };

/// A line that leaves something in memory.
struct Item {
    ItemKind kind = ItemKind::instruction;
    Section section = Section::text;
    std::int64_t offset_bytes = 0;  // in its section
    std::int64_t repeats = 1;
    const Line* line = nullptr;
    std::size_t first_token = 0;  // of the instruction, or of the list of values
};

struct Meaning {
    Section section = Section::none;  // none: a number
    std::int64_t value = 0;           // or an offset in the section
};

struct Layout {
    isa::Dialect dialect = isa::Dialect::dsp32;
    std::vector<Item> items;
    std::map<std::string, Meaning, std::less<>> names;
    std::int64_t text_bytes = 0;
    std::int64_t data_bytes = 0;

    /// The data lies behind the text, from a multiple of four on.
    [[nodiscard]] std::int64_t data_address() const { return (text_bytes + 3) / 4 * 4; }
    [[nodiscard]] std::int64_t address_of(Section section, std::int64_t offset) const {
        return offset + (section == Section::data ? data_address() : 0);
    }
    [[nodiscard]] std::int64_t words() const { return (data_address() + data_bytes + 3) / 4; }
};

/// No program is longer: what comes after it is not looked at.
inline constexpr std::int64_t most_bytes = std::int64_t{1} << 24;

[[nodiscard]] Layout layout_of(const std::vector<Line>& lines, isa::Dialect dialect,
                               Mistakes& mistakes);

}  // namespace pxm::dsp32::assembler
