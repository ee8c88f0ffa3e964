// An instruction made ready to be executed: fields spread out, pointers' steps looked up. Made once
// a word, when it is first fetched.
#pragma once

#include "pxm/dsp32/isa/instruction.hpp"
#include "pxm/dsp32/isa/names.hpp"

namespace pxm::dsp32::processor {

/// What to do; the operations of the table, less what a processor does not tell apart, plus what
/// it stops at.
enum class Step : std::uint8_t {
    unknown,       // not looked at yet
    illegal,       // no instruction of the first DSP32
    not_modelled,  // an instruction that needs a port, or companded numbers
    add_product,
    copy,
    add,
    product_add,  // as isa::Operation
    tap_add,
    tap_product_add,
    to_float,
    to_integer,
    round,
    select_less,
    select_equal,
    select_greater,
    branch,
    loop_branch,
    call,
    add_constant,
    alu_register,
    alu_constant,
    load,
    store,
};

/// An operand of the data unit: memory at a pointer, whose step is a register plus a constant; or,
/// without a pointer, an accumulator.
struct DecodedOperand {
    std::uint8_t pointer = 0;        // a register's code
    std::uint8_t accumulator = 0;    // 0 to 3
    std::uint8_t step_register = 0;  // a register's code; 0: none
    std::int8_t step_bytes = 0;      // added to the register's
    bool present = false;            // whether there is such an operand
};

struct Decoded {                 // an instruction in its parts
    Step step = Step::unknown;   // what it does
    bool negate_first = false;   // the adder's operand that is no product
    bool negate_second = false;  // the product
    std::uint8_t n = 0;          // result: an accumulator
    std::uint8_t m = 0;          // an accumulator, or constant_zero or constant_one
    DecodedOperand x;            // of the multiplier
    DecodedOperand y;            // of the adder, or of the multiplier
    DecodedOperand z;            // where the result goes
    // The control unit.
    isa::Alu alu = isa::Alu::add;  // of two registers, or one and a constant
    std::uint8_t condition = 0;    // by isa::condition_names
    std::uint8_t d = 0;            // result, counter, link or what is moved
    std::uint8_t u = 0;            // source, or base of a branch
    std::uint8_t width = 0;        // by isa::width_suffixes
    bool direct = false;           // a move at a constant address
    std::uint16_t constant = 0;    // of 16 bits, or an address
    std::uint32_t reads = 0;       // registers, as a set
};

/// Values of `m` beyond a0 to a3.
inline constexpr std::uint8_t constant_zero = 4;  // 0.0
inline constexpr std::uint8_t constant_one = 5;   // 1.0

[[nodiscard]] Decoded decoded(Word word) noexcept;  // what a word says

}  // namespace pxm::dsp32::processor
