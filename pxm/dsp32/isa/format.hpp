// The instruction set of the DSP32 family as data: one table of formats, from which encoding,
// decoding and the disassembler work. A row is one shape of a 32-bit word; its pattern says what
// every bit is. What the first DSP32 is believed to have had comes first; what the DSP32C added is
// marked and switched by the dialect. Sources and doubts: docs/dsp32.md.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "pxm/dsp32/word.hpp"
#include "pxm/model.hpp"

namespace pxm::dsp32::isa {

/// Which member of the family a program is for.
enum class Dialect : std::uint8_t { dsp32, dsp32c };

/// What an instruction does; the shapes of operands are the format's.
enum class Operation : std::uint8_t {
    // the data unit
    add_product,      // Z = aN = [-]Y +- aM * X
    copy,             // Z = aN = [-]Y
    add,              // Z = aN = [-]Y +- X
    tap_add,          // aN = [-](Z = Y) +- X
    tap_product_add,  // aN = [-]aM +- (Z = Y) * X
    tap_product,      // aN = [-](Z = Y) * X
    tap_product_one,  // aN = [-]1.0 +- (Z = Y) * X
    product_add,      // Z = aN = [-]aM +- Y * X
    product,          // Z = aN = [-]Y * X
    product_one,      // Z = aN = [-]1.0 +- Y * X
    special,          // Z = aN = function(Y)
    // the control unit
    branch,
    loop_branch,
    call,
    add_constant,  // rD = rS + N
    alu_register,
    alu_constant,
    move_direct,   // register and memory at a constant address
    move_pointer,  // register and memory at a pointer
    do_constant,
    do_register,
    goto_long,
    load_long,
    call_long,
    interrupt_return,
};

/// A field of a word: which letter of the pattern, where its lowest bit is, how wide it is.
struct Field {
    char letter = 0;  // of the pattern
    int low_bit = 0;  // counted from 0
    int bits = 0;     // how many
};

inline constexpr int most_fields = 8;  // of one format

/// One row of the table. In a pattern 0 and 1 are fixed, a letter is a bit of a field, bit 31
/// first.
///   n aN    m aM    f sign of the adder's operand    s sign of the product
///   x X     y Y     z Z or none     t Z, which must write       g special function
///   c branch condition   k condition of an ALU instruction
///   b base of a branch   l link register   j counter of a loop branch
///   d result   r source of add_constant   u, v sources of the ALU
///   a function of two operands   o of three   h with a constant
///   i constant of 16 bits   H the 8 bits above them   w width   e register of a move
///   T direction of a move   p pointer   q its increment   K length of a loop   N its count
struct Format {
    std::string_view name;                    // as the sources number them
    Operation operation;                      // what it does
    std::string_view pattern;                 // 32 letters, bit 31 first
    Dialect since;                            // who has it
    Certainty certainty;                      // of `since`; the encodings themselves are S [S7, S8]
    bool wide = false;                        // operates on 24 bits
    Word fixed_mask = 0;                      // bits that are 0 or 1
    Word fixed_bits = 0;                      // what they are
    int field_count = 0;                      // how many fields there are
    std::array<Field, most_fields> fields{};  // the fields, in the order of the letters
};

/// All formats. No two match the same word.
[[nodiscard]] std::span<const Format> formats() noexcept;

/// A value of a field that came with the DSP32C.
struct Addition {
    std::string_view letters;  // of the fields that may hold it
    unsigned first;            // the first value
    unsigned last;             // the last value
    Certainty certainty;       // of who has it
    std::string_view what;     // what the values mean
};
[[nodiscard]] std::span<const Addition> additions() noexcept;  // all of them

/// Whether a field may hold a value. What is reserved in the sources, or has a second spelling
/// there, may not: docs/dsp32.md lists it.
[[nodiscard]] bool field_allows(char letter, unsigned value, Dialect dialect) noexcept;

}  // namespace pxm::dsp32::isa
