// Instructions of the data unit as they are written: [Z =] aN = [-]Y + aM * X and its kin.
#pragma once

#include "pxm/dsp32/assembler/cursor.hpp"
#include "pxm/dsp32/isa/instruction.hpp"

namespace pxm::dsp32::assembler {

enum class Access : std::uint8_t { read, write };  // what an operand is for

/// Memory at a pointer, and what is added to the pointer afterwards: nothing, a register, or the
/// codes of -- and ++.
struct Memory {
    unsigned pointer = 0;  // 1 to 14, of r1 to r14
    unsigned step = 0;     // a register's code, 0 for none
};
[[nodiscard]] std::optional<Memory> memory_operand(Cursor& cursor);  // nothing after a mistake

/// The seven bits of an operand.
[[nodiscard]] std::optional<unsigned> data_operand(Cursor& cursor, Access access);

/// What follows `Z =`, from aN on.
[[nodiscard]] std::optional<Word> data_instruction(Cursor& cursor, isa::Dialect dialect,
                                                   std::optional<unsigned> z);

}  // namespace pxm::dsp32::assembler
