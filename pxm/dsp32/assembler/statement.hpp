// What the parsers of instructions share: a line that is being read, and the making of its word.
#pragma once

#include "pxm/dsp32/assembler/instruction_parser.hpp"

namespace pxm::dsp32::assembler {

inline constexpr std::int64_t least_16 = -32768;       // of a constant of 16 bits
inline constexpr std::int64_t most_16 = 65535;         // the same without a sign
inline constexpr std::int64_t most_signed_16 = 32767;  // and with one
inline constexpr std::int64_t most_24 = 0xFF'FFFF;     // of an address of the DSP32C

/// The lower 16 bits of a constant.
[[nodiscard]] constexpr unsigned bits_16(std::int64_t number) {
    return static_cast<unsigned>(number) & 0xFFFFU;
}

struct Statement {                      // an instruction that is being read
    Cursor& cursor;                     // where in the line
    const Surroundings& around;         // what it may depend on
    Place start;                        // of the instruction
    std::optional<unsigned> condition;  // of an ALU instruction

    /// The word with these fields; a mistake if the dialect has none.
    std::optional<Word> word(isa::Operation operation, isa::FieldValues values, bool wide = false);
};

/// goto, pcgoto, call, return, do and if, after the keyword.
[[nodiscard]] std::optional<Word> branch_instruction(Statement& in, std::string_view keyword);
/// *rP++ = ..., *address = ...
[[nodiscard]] std::optional<Word> store_instruction(Statement& in);
/// rD = *..., from the star on.
[[nodiscard]] std::optional<Word> load_instruction(Statement& in, RegisterName result);
/// obuf = aN = ...
[[nodiscard]] std::optional<Word> port_instruction(Statement& in);
/// An instruction that starts with a register, after the register.
[[nodiscard]] std::optional<Word> register_instruction(Statement& in, RegisterName result);

}  // namespace pxm::dsp32::assembler
