// What the data unit executes. Part of processor.cpp.
#pragma once

#include "pxm/dsp32/processor/processor.hpp"

namespace pxm::dsp32::processor {

namespace {

constexpr dsp32::Addend nothing{0, zero_exponent};

constexpr dsp32::Addend with_sign(dsp32::Addend addend, bool minus) noexcept {
    return minus ? negative(addend) : addend;
}

/// The flags of a sum. Range is judged only where it can have been left: at zero and at the end.
inline DataFlags flags_of(const Accumulator& result, dsp32::Addend a, dsp32::Addend b) noexcept {
    DataFlags flags{result.mantissa < 0, result.mantissa == 0, false, false};
    if (flags.zero) [[unlikely]] {
        const int exponent = std::max(a.exponent, b.exponent);
        flags.underflow = (a.mantissa >> std::min(exponent - a.exponent, 63)) +
                              (b.mantissa >> std::min(exponent - b.exponent, 63)) !=
                          0;
    } else if (result.exponent == largest_exponent) [[unlikely]] {
        const bool before = overflowed;
        overflowed = false;
        static_cast<void>(sum(a, b));
        flags.overflow = overflowed;
        overflowed = overflowed || before;
    }
    return flags;
}

}  // namespace

inline std::uint32_t Processor::address_and_step(const DecodedOperand& operand) noexcept {
    std::uint16_t& pointer = registers_[operand.pointer];
    const std::uint32_t address = pointer;
    pointer = static_cast<std::uint16_t>(pointer + registers_[operand.step_register] +
                                         operand.step_bytes);
    return address;
}

inline Word Processor::operand_word(const DecodedOperand& operand) {
    return read_word(address_and_step(operand));
}

/// An operand on its way into the adder.
inline Addend Processor::operand_addend(const DecodedOperand& operand) {
    if (operand.pointer == 0) return widened(data_.value(operand.accumulator));
    return widened(dsp32::load(operand_word(operand)));
}

inline Word Processor::multiplier_accumulator(unsigned number) {
    bool stale = false;
    const Word word = data_.multiplier_input(number, now_, stale);
    if (stale) [[unlikely]]
        note_stale(StaleKind::accumulator);
    return word;
}

inline Word Processor::multiplier_word(const DecodedOperand& operand) {
    if (operand.pointer == 0) return multiplier_accumulator(operand.accumulator);
    return operand_word(operand);
}

inline Addend Processor::adder_input(unsigned m) {
    if (m == constant_zero) return nothing;
    if (m == constant_one) return widened(one);
    return widened(data_.value(m));
}

inline void Processor::write_result(const DecodedOperand& z, Word value, bool half) {
    const std::uint32_t address = address_and_step(z);
    const std::uint64_t due = now_ + memory_latency;
    writes_[due % memory_latency] = {address, value, half, due};
    last_due_ = due;
}

inline void Processor::finish(const Decoded& in, Addend first, Addend second) {
    const Accumulator result = sum(first, second);
    data_.set(in.n, result, now_);
    data_.set_flags(flags_of(result, first, second), now_);
    const bool tap = in.step == Step::tap_add || in.step == Step::tap_product_add;
    if (in.z.present && !tap) write_result(in.z, store(result), false);
}

inline void Processor::execute_data(const Decoded& in) {
    switch (in.step) {
        case Step::add_product: {
            const Word x = multiplier_word(in.x);
            const Addend y = operand_addend(in.y);
            const Word m = multiplier_accumulator(in.m);
            return finish(in, with_sign(y, in.negate_first),
                          with_sign(product(m, x), in.negate_second));
        }
        case Step::copy:
            return finish(in, with_sign(operand_addend(in.y), in.negate_first), nothing);
        case Step::add: {
            const Word x = multiplier_word(in.x);
            const Addend y = operand_addend(in.y);
            return finish(in, with_sign(y, in.negate_first),
                          with_sign(product(one, x), in.negate_second));
        }
        case Step::tap_add: {
            const Word x = multiplier_word(in.x);
            const Addend y = operand_addend(in.y);
            finish(in, with_sign(y, in.negate_first), with_sign(product(one, x), in.negate_second));
            return write_result(in.z, store(sum(y, nothing)), false);
        }
        default: {
            const Word x = multiplier_word(in.x);
            const Word y = multiplier_word(in.y);
            finish(in, with_sign(adder_input(in.m), in.negate_first),
                   with_sign(product(y, x), in.negate_second));
            // What passes the multiplier has no guard bits; a zero is written as the one zero.
            if (in.step == Step::tap_product_add) write_result(in.z, store(dsp32::load(y)), false);
            return;
        }
    }
}

namespace {

/// A conversion's rounding mode is in two bits of the control register dauc [S8].
inline int integer_of(const Accumulator& value, unsigned dauc) noexcept {
    constexpr unsigned down = 0x10, toward_zero = 0x20;
    if ((dauc & down) == 0) return nearest_integer(value);
    const int below = floor_integer(value);
    const bool exact = dsp32::load(word_of_integer(below)) == value;
    const bool saturated = below == -32768;
    if ((dauc & toward_zero) == 0 || value.mantissa >= 0 || exact || saturated) return below;
    return below + 1;
}

}  // namespace

inline void Processor::execute_special(const Decoded& in) {
    if (in.step == Step::to_float) {
        const auto half = static_cast<std::int16_t>(read_part(address_and_step(in.y), 2));
        return finish(in, widened(dsp32::load(word_of_integer(half))), nothing);
    }
    if (in.step == Step::select_less || in.step == Step::select_equal ||
        in.step == Step::select_greater) {
        const DataFlags flags = data_.flags();  // at once [S7, S8]
        const bool taken = in.step == Step::select_less    ? flags.negative
                           : in.step == Step::select_equal ? flags.zero
                                                           : !flags.negative && !flags.zero;
        if (taken) data_.set(in.n, sum(operand_addend(in.y), nothing), now_);
        if (in.z.present) write_result(in.z, store(data_.value(in.n)), false);
        return;
    }
    const Accumulator value = sum(operand_addend(in.y), nothing);
    if (in.step == Step::to_integer) {
        const int integer = integer_of(value, registers_[isa::register_dauc]);
        data_.set(in.n, {}, now_);  // what it holds is no number [S8]; chosen: zero
        if (in.z.present) write_result(in.z, static_cast<Word>(integer), true);
        return;
    }
    finish(in, widened(dsp32::load(round(value))), nothing);
}

}  // namespace pxm::dsp32::processor
