// The first pass: what every line of a program is, where it lies, and what the names mean.
#pragma once

#include <map>
#include <string>

#include "pxm/dsp32/assembler/cursor.hpp"
#include "pxm/dsp32/isa/format.hpp"

namespace pxm::dsp32::assembler {

enum class Section : std::uint8_t { text, data, none };  // where an item lies; none: it is a number
enum class ItemKind : std::uint8_t { instruction, reals, halves, words };  // what an item is

/// A line that leaves something in memory.
struct Item {
    ItemKind kind = ItemKind::instruction;  // an instruction, or what values it has
    Section section = Section::text;        // where it lies
    std::int64_t offset_bytes = 0;          // in its section
    std::int64_t repeats = 1;               // of the values
    const Line* line = nullptr;             // that it stands in
    std::size_t first_token = 0;            // of the instruction, or of the list of values
};

struct Meaning {                      // what a name stands for
    Section section = Section::none;  // none: a number
    std::int64_t value = 0;           // or an offset in the section
};

struct Layout {                                         // where everything of a program lies
    isa::Dialect dialect = isa::Dialect::dsp32;         // whose instructions it has
    std::vector<Item> items;                            // in the order of the source
    std::map<std::string, Meaning, std::less<>> names;  // of labels and numbers
    std::int64_t text_bytes = 0;                        // of the section
    std::int64_t data_bytes = 0;                        // of the section

    /// The data lies behind the text, from a multiple of four on.
    [[nodiscard]] std::int64_t data_address() const { return (text_bytes + 3) / 4 * 4; }
    /// In the program, of an offset in a section.
    [[nodiscard]] std::int64_t address_of(Section section, std::int64_t offset) const {
        return offset + (section == Section::data ? data_address() : 0);
    }
    /// Of the program.
    [[nodiscard]] std::int64_t words() const { return (data_address() + data_bytes + 3) / 4; }
};

/// No program is longer: what comes after it is not looked at.
inline constexpr std::int64_t most_bytes = std::int64_t{1} << 24;

/// Mistakes are added to the last.
[[nodiscard]] Layout layout_of(const std::vector<Line>& lines, isa::Dialect dialect,
                               Mistakes& mistakes);

}  // namespace pxm::dsp32::assembler
