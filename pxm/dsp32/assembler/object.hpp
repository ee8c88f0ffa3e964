// An assembled program: the words of fast memory from address 0 on, and the names of addresses.
// There is one program on a node, so nothing is left for a linker.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pxm/dsp32/isa/format.hpp"

namespace pxm::dsp32::assembler {

struct Symbol {                 // a name of an address
    std::string name;           // a label
    std::uint32_t address = 0;  // in bytes
    bool operator==(const Symbol&) const = default;
};

struct Object {                                  // an assembled program
    isa::Dialect dialect = isa::Dialect::dsp32;  // whose instructions it has
    std::vector<Word> text;                      // from address 0
    std::vector<Word> data;                      // behind the text
    std::vector<Symbol> symbols;                 // by address, then by name

    /// Of text and data.
    [[nodiscard]] std::size_t words() const { return text.size() + data.size(); }
    /// The address of a name.
    [[nodiscard]] std::optional<std::uint32_t> address_of(std::string_view name) const;
    /// A name of an address: the first one; empty if it has none.
    [[nodiscard]] std::string name_of(std::uint32_t address) const;
    bool operator==(const Object&) const = default;
};

/// The object as the text of a file: docs/dsp32.md has the form.
[[nodiscard]] std::string text_of(const Object& object);

/// The object in the text of a file, or nothing if it is none.
[[nodiscard]] std::optional<Object> object_of(std::string_view text);

/// The program as assembler source, with its labels.
[[nodiscard]] std::string disassembly(const Object& object);

}  // namespace pxm::dsp32::assembler
