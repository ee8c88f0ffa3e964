#include "pxm/dsp32/processor/decoded.hpp"

namespace pxm::dsp32::processor {

namespace {

using isa::Instruction;
using isa::Operation;

constexpr unsigned no_write = 7;

std::uint32_t bit(unsigned code) { return std::uint32_t{1} << code; }
std::uint8_t byte(unsigned value) { return static_cast<std::uint8_t>(value); }

bool is_port(unsigned field) { return field >= 4 && field <= 6; }

DecodedOperand operand(unsigned field, int unit_bytes) {
    const unsigned pointer = field >> 3U, index = field & 7U;
    if (pointer == 0) return {0, byte(index & 3U), 0, 0, field != no_write};
    DecodedOperand result{byte(pointer), 0, 0, 0, true};
    if (index >= 6) {
        result.step_bytes = static_cast<std::int8_t>(index == 6 ? -unit_bytes : unit_bytes);
    } else if (index != 0) {
        result.step_register = byte(isa::register_r15 + index - 1);
    }
    return result;
}

std::uint32_t reads_of(const DecodedOperand& operand) {
    return operand.pointer == 0 ? 0 : bit(operand.pointer) | bit(operand.step_register);
}

Step special_step(unsigned function) {
    constexpr std::array<Step, 8> steps{Step::not_modelled, Step::not_modelled,  Step::to_float,
                                        Step::to_integer,   Step::round,         Step::select_less,
                                        Step::select_equal, Step::select_greater};
    return steps[function];
}

Step data_step(const Instruction& in) {
    switch (in.operation()) {
        case Operation::add_product:
            return Step::add_product;
        case Operation::copy:
            return Step::copy;
        case Operation::add:
            return Step::add;
        case Operation::tap_add:
            return Step::tap_add;
        case Operation::tap_product_add:
        case Operation::tap_product:
        case Operation::tap_product_one:
            return Step::tap_product_add;
        case Operation::special:
            return special_step(in.value('g'));
        default:
            return Step::product_add;
    }
}

std::uint8_t adder_input(const Instruction& in) {
    switch (in.operation()) {
        case Operation::product:
        case Operation::tap_product:
            return constant_zero;
        case Operation::product_one:
        case Operation::tap_product_one:
            return constant_one;
        default:
            return byte(in.value('m'));
    }
}

Decoded data_instruction(const Instruction& in) {
    Decoded result;
    result.step = data_step(in);
    const bool integers = result.step == Step::to_float || result.step == Step::to_integer;
    const unsigned z = in.value(in.has('t') ? 't' : 'z');
    if (is_port(in.value('x')) || is_port(in.value('y')) || is_port(z))
        result.step = Step::not_modelled;
    result.negate_first = in.value('f') != 0;
    result.negate_second = in.value('s') != 0;
    result.n = byte(in.value('n'));
    result.m = adder_input(in);
    result.x = operand(in.value('x'), 4);
    result.y = operand(in.value('y'), result.step == Step::to_float ? 2 : 4);
    result.z = operand(z, integers && result.step == Step::to_integer ? 2 : 4);
    // Where an accumulator holds an integer is not in its number.
    if (result.step == Step::to_float && result.y.pointer == 0) result.step = Step::not_modelled;
    result.reads = reads_of(result.x) | reads_of(result.y) | reads_of(result.z);
    return result;
}

Step control_step(Operation operation) {
    switch (operation) {
        case Operation::branch:
            return Step::branch;
        case Operation::loop_branch:
            return Step::loop_branch;
        case Operation::call:
            return Step::call;
        case Operation::add_constant:
            return Step::add_constant;
        case Operation::alu_register:
            return Step::alu_register;
        case Operation::alu_constant:
            return Step::alu_constant;
        default:
            return Step::load;
    }
}

/// Registers that an instruction of the control unit looks at.
std::uint32_t control_reads(const Instruction& in, Step step) {
    std::uint32_t reads = 0;
    for (const char letter : {'b', 'r', 'u', 'j', 'p'})
        if (in.has(letter)) reads |= bit(in.value(letter));
    if (in.has('q') && in.value('q') < isa::decrement_code) reads |= bit(in.value('q'));
    if (step == Step::alu_register || step == Step::alu_constant) reads |= bit(in.value('d'));
    if (step == Step::store) reads |= bit(in.value('e'));
    return reads & ~bit(isa::register_zero);
}

int width_bytes(unsigned width) { return width == 2 ? 2 : 1; }

Decoded control_instruction(const Instruction& in) {
    Decoded result;
    result.step = control_step(in.operation());
    if (result.step == Step::load && in.value('T') != 0) result.step = Step::store;
    result.alu = static_cast<isa::Alu>(in.value(in.has('a') ? 'a' : 'h'));
    result.condition = byte(in.value('c'));
    for (const char letter : {'d', 'j', 'l', 'e'})
        if (in.has(letter)) result.d = byte(in.value(letter));
    for (const char letter : {'b', 'r', 'u'})
        if (in.has(letter)) result.u = byte(in.value(letter));
    result.width = byte(in.value('w'));
    result.direct = in.operation() == Operation::move_direct;
    result.constant = static_cast<std::uint16_t>(in.value('i'));
    if (in.operation() == Operation::move_pointer) {
        const unsigned step = in.value('q');
        result.y = {byte(in.value('p')), 0, 0, 0, true};
        const int unit = width_bytes(in.value('w'));
        if (step == isa::decrement_code || step == isa::increment_code) {
            result.y.step_bytes =
                static_cast<std::int8_t>(step == isa::increment_code ? unit : -unit);
        } else {
            result.y.step_register = byte(step);
        }
    }
    constexpr unsigned first_port_condition = 32;
    if (result.step == Step::branch && in.value('c') >= first_port_condition)
        result.step = Step::not_modelled;
    result.reads = control_reads(in, result.step);
    return result;
}

}  // namespace

Decoded decoded(Word word) noexcept {
    const auto instruction = isa::decode(word, isa::Dialect::dsp32);
    if (!instruction) {
        Decoded illegal;
        illegal.step = Step::illegal;
        return illegal;
    }
    if (instruction->operation() <= Operation::special) return data_instruction(*instruction);
    return control_instruction(*instruction);
}

}  // namespace pxm::dsp32::processor
