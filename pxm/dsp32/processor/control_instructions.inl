// What the control unit executes. Part of processor.cpp.
#pragma once

#include "pxm/dsp32/processor/processor.hpp"

namespace pxm::dsp32::processor {

inline std::uint16_t Processor::source(unsigned code) const noexcept {
    if (code == isa::register_pc) return static_cast<std::uint16_t>(pc_ + 8);
    return registers_[code];
}

/// A constant behind no register is an address.
inline std::uint32_t Processor::branch_address(const Decoded& in) const noexcept {
    return static_cast<std::uint16_t>(source(in.u) + in.constant);
}

inline bool Processor::holds_for_data(unsigned condition, DataFlags flags) const noexcept {
    switch (condition / 2) {  // the odd ones are the opposites: all but the first are named by 0
        case 8:
            return !flags.underflow;
        case 9:
            return !flags.negative;
        case 10:
            return !flags.zero;
        case 11:
            return !flags.overflow;
        default:
            return !flags.negative && !flags.zero;
    }
}

inline bool Processor::holds(unsigned condition) {
    const bool opposite = condition % 2 != 0;
    constexpr unsigned first_data_condition = 16;
    if (condition >= first_data_condition) {
        bool stale = false;
        const DataFlags flags = data_.condition_flags(now_, stale);
        if (stale) note_stale(StaleKind::condition);
        return holds_for_data(condition, flags) != opposite;
    }
    const bool less = flags_.negative != flags_.overflow;
    switch (condition / 2) {
        case 0:
            return opposite;
        case 1:
            return !flags_.negative != opposite;
        case 2:
            return !flags_.zero != opposite;
        case 3:
            return !flags_.overflow != opposite;
        case 4:
            return !flags_.carry != opposite;
        case 5:
            return !less != opposite;
        case 6:
            return !(flags_.zero || less) != opposite;
        default:
            return !(flags_.carry || flags_.zero) != opposite;
    }
}

inline std::uint16_t Processor::integer_sum(std::uint32_t a, std::uint32_t b) noexcept {
    const std::uint32_t result = a + b;
    flags_ = {(result & 0x8000U) != 0, (result & 0xFFFFU) == 0, (result >> 16U) != 0,
              (~(a ^ b) & (a ^ result) & 0x8000U) != 0};
    return static_cast<std::uint16_t>(result);
}

inline std::uint16_t Processor::integer_difference(std::uint32_t a, std::uint32_t b) noexcept {
    const std::uint32_t result = a - b;
    flags_ = {(result & 0x8000U) != 0, (result & 0xFFFFU) == 0, a < b,
              ((a ^ b) & (a ^ result) & 0x8000U) != 0};
    return static_cast<std::uint16_t>(result);
}

inline std::uint16_t Processor::logical(std::uint32_t result, bool carry) noexcept {
    flags_ = {(result & 0x8000U) != 0, (result & 0xFFFFU) == 0, carry, false};
    return static_cast<std::uint16_t>(result);
}

namespace {

/// An addition whose carries run from the highest bit to the lowest, for addresses of transforms.
inline std::uint32_t reversed(std::uint32_t bits) noexcept {
    std::uint32_t result = 0;
    for (unsigned i = 0; i < 16; ++i) result |= (bits >> i & 1U) << (15 - i);
    return result;
}

}  // namespace

/// a is the result's register or the first operand, b the other one or the only one.
inline void Processor::calculate(isa::Alu function, unsigned d, std::uint16_t a, std::uint16_t b) {
    using enum isa::Alu;
    const bool carry = flags_.carry;
    std::uint16_t& result = registers_[d];
    switch (function) {
        case add:
            result = integer_sum(a, b);
            break;
        case twice:
            result = integer_sum(b, b);
            break;
        case subtract_from:
            result = integer_difference(b, a);
            break;
        case add_reversed: {
            const std::uint32_t total = reversed(a) + reversed(b);
            result = logical(reversed(total), (total >> 16U) != 0);
            break;
        }
        case subtract:
            result = integer_difference(a, b);
            break;
        case negate:
            result = integer_difference(0, b);
            break;
        case and_not:
            result = logical(a & ~std::uint32_t{b});
            break;
        case compare:
            static_cast<void>(integer_difference(a, b));
            break;
        case exclusive_or:
            result = logical(std::uint32_t{a} ^ b);
            break;
        case rotate_right:
            result = logical((b >> 1U) | (carry ? 0x8000U : 0U), (b & 1U) != 0);
            break;
        case inclusive_or:
            result = logical(std::uint32_t{a} | b);
            break;
        case rotate_left:
            result = logical((std::uint32_t{b} << 1U) | (carry ? 1U : 0U), (b & 0x8000U) != 0);
            break;
        case shift_right:
            result = logical(std::uint32_t{b} >> 1U, (b & 1U) != 0);
            break;
        case half:
            result = logical((std::uint32_t{b} >> 1U) | (b & 0x8000U), (b & 1U) != 0);
            break;
        case conjunction:
            result = logical(std::uint32_t{a} & b);
            break;
        case test:
            static_cast<void>(logical(std::uint32_t{a} & b));
            break;
    }
}

inline void Processor::load_register(const Decoded& in) {
    const std::uint32_t address = in.direct ? in.constant : address_and_step(in.y);
    constexpr unsigned high = 0, whole = 2;
    const std::uint32_t read = read_part(address, in.width == whole ? 2 : 1);
    const std::uint32_t value = in.width == high ? read << 8U : read;
    static_cast<void>(logical(value));
    // A register loaded just before gets its value now; this one after the next instruction.
    if (load_due_ == now_ + 1) registers_[loaded_register_] = loaded_value_;
    loaded_register_ = in.d;
    loaded_value_ = static_cast<std::uint16_t>(value);
    load_due_ = now_ + 2;
}

inline void Processor::store_register(const Decoded& in) {
    constexpr unsigned high = 0, whole = 2;
    const std::uint32_t value = registers_[in.d];
    const std::uint32_t address = in.direct ? in.constant : address_and_step(in.y);
    write_part(address, in.width == whole ? 2 : 1, in.width == high ? value >> 8U : value);
}

inline void Processor::execute_control(const Decoded& in) {
    switch (in.step) {
        case Step::branch:
            if (holds(in.condition)) branch_to(branch_address(in));
            break;
        case Step::loop_branch: {
            const std::uint32_t target = branch_address(in);
            if (static_cast<std::int16_t>(registers_[in.d]--) >= 0) branch_to(target);
            break;
        }
        case Step::call: {
            const std::uint32_t target = branch_address(in);
            registers_[in.d] = static_cast<std::uint16_t>(pc_ + 8);
            branch_to(target);
            break;
        }
        case Step::add_constant:
            registers_[in.d] = integer_sum(source(in.u), in.constant);
            break;
        case Step::alu_register:
            calculate(in.alu, in.d, registers_[in.d], registers_[in.u]);
            break;
        case Step::alu_constant:
            calculate(in.alu, in.d, registers_[in.d], in.constant);
            break;
        case Step::load:
            load_register(in);
            break;
        default:
            store_register(in);
            break;
    }
}

}  // namespace pxm::dsp32::processor
