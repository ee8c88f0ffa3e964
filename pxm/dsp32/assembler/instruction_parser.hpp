// One line of assembler source as the word of an instruction.
#pragma once

#include "pxm/dsp32/assembler/cursor.hpp"
#include "pxm/dsp32/isa/instruction.hpp"

namespace pxm::dsp32::assembler {

/// What an instruction may depend on besides its text.
struct Surroundings {
    std::uint32_t address = 0;                   // of the instruction
    std::uint32_t program_bytes = 0;             // branches lead to what lies below
    isa::Dialect dialect = isa::Dialect::dsp32;  // whose instructions there are
};

/// The word of the instruction that is the rest of the line; empty after a mistake.
[[nodiscard]] std::optional<Word> instruction_word(Cursor& cursor, const Surroundings& around);

/// Why no word has these fields.
[[nodiscard]] std::string no_such_instruction(isa::Operation operation, bool wide,
                                              isa::FieldValues values);

/// Words that begin instructions, and so cannot be labels.
[[nodiscard]] bool is_reserved(std::string_view name);

}  // namespace pxm::dsp32::assembler
