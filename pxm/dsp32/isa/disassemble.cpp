#include "pxm/dsp32/isa/disassemble.hpp"

#include <cstdlib>

#include "pxm/dsp32/isa/names.hpp"

namespace pxm::dsp32::isa {

namespace {

using Text = std::string;

/// Texts one behind the other.
template <class... Parts>
Text joined(const Parts&... parts) {
    Text text;
    ((text += parts), ...);
    return text;
}

Text hexadecimal(std::uint32_t number, int digits) {
    static constexpr char digit[] = "0123456789abcdef";
    Text text;
    while (number != 0 || digits > 0) {
        text.insert(text.begin(), digit[number & 15U]);
        number >>= 4U;
        --digits;
    }
    return joined("0x", text);
}
Text hexadecimal(std::uint32_t number) { return hexadecimal(number, 1); }

Text signed_constant(int number) {
    return joined(number < 0 ? "-" : "", hexadecimal(static_cast<std::uint32_t>(std::abs(number))));
}

Text accumulator(unsigned number) { return joined("a", std::to_string(number)); }
Text name(unsigned code) { return Text(register_names[code]); }

/// An operand of the data unit: an accumulator, a port, or memory and what becomes of its pointer.
Text operand(unsigned field) {
    const unsigned pointer = field >> 3U, index = field & 7U;
    if (pointer == 0) return index < 4 ? accumulator(index) : Text(port_names[index]);
    const Text memory = joined("*r", std::to_string(pointer));
    if (index == 0) return memory;
    if (index >= 6) return memory + (index == 6 ? "--" : "++");
    return joined(memory, "++r", std::to_string(14 + index));
}

/// A DA instruction put together from its parts.
struct DataText {
    const Instruction& in;

    [[nodiscard]] Text x() const { return operand(in.value('x')); }
    [[nodiscard]] Text y() const { return operand(in.value('y')); }
    [[nodiscard]] Text tap() const { return joined("(", operand(in.value('t')), " = ", y(), ")"); }
    [[nodiscard]] Text m() const { return accumulator(in.value('m')); }
    [[nodiscard]] Text minus(char letter) const { return in.value(letter) != 0 ? "-" : ""; }
    [[nodiscard]] Text sign() const { return in.value('s') != 0 ? " - " : " + "; }

    [[nodiscard]] Text value() const {
        switch (in.operation()) {
            case Operation::add_product:
                return joined(minus('f'), y(), sign(), m(), " * ", x());
            case Operation::copy:
                return joined(minus('f'), y());
            case Operation::add:
                return joined(minus('f'), y(), sign(), x());
            case Operation::tap_add:
                return joined(minus('f'), tap(), sign(), x());
            case Operation::tap_product_add:
                return joined(minus('f'), m(), sign(), tap(), " * ", x());
            case Operation::tap_product:
                return joined(minus('s'), tap(), " * ", x());
            case Operation::tap_product_one:
                return joined(minus('f'), "1.0", sign(), tap(), " * ", x());
            case Operation::product_add:
                return joined(minus('f'), m(), sign(), y(), " * ", x());
            case Operation::product:
                return joined(minus('s'), y(), " * ", x());
            case Operation::product_one:
                return joined(minus('f'), "1.0", sign(), y(), " * ", x());
            default:
                return Text(function_names[in.value('g')]) + "(" + y() + ")";
        }
    }
    [[nodiscard]] Text text() const {
        constexpr unsigned no_write = 7;
        const Text sum = accumulator(in.value('n')) + " = " + value();
        if (!in.has('z') || in.value('z') == no_write) return sum;
        return operand(in.value('z')) + " = " + sum;
    }
};

Text plus_constant(int number) {
    if (number == 0) return "";
    return joined((number < 0 ? " - " : " + "),
                  hexadecimal(static_cast<std::uint32_t>(std::abs(number))));
}

/// The address in a field of 16 bits: the DSP32C extends its sign to 24 bits.
std::uint32_t address_in(const Instruction& in, Dialect dialect) {
    if (dialect == Dialect::dsp32) return in.value('i');
    return static_cast<std::uint32_t>(in.constant()) & 0xFF'FFFFU;
}

/// Where a branch leads: an address, or a register and what is added to it.
Text target(const Instruction& in, Dialect dialect) {
    const unsigned base = in.value('b');
    if (in.has('H')) {
        const auto constant = in.long_constant();
        if (base == register_zero) return hexadecimal(constant);
        return joined(name(base), constant != 0 ? joined(" + ", hexadecimal(constant)) : "");
    }
    if (base == register_zero) return hexadecimal(address_in(in, dialect));
    return name(base) + plus_constant(in.constant());
}

Text condition(const Instruction& in, char letter) {
    return joined("if (", Text(condition_names[in.value(letter)]), ") ");
}

Text branch(const Instruction& in, Dialect dialect) {
    if (encode(in) == nop) return "nop";
    const Text to = joined("goto ", target(in, dialect));
    return in.value('c') == condition_true ? to : condition(in, 'c') + to;
}

/// With "e" behind a register that is used with 24 bits.
Text wide(const Instruction& in, unsigned code) {
    return name(code) + (in.format->wide ? "e" : "");
}

Text add_constant(const Instruction& in) {
    const Text result = wide(in, in.value('d')) + " = ";
    if (in.value('r') == register_zero) return result + signed_constant(in.constant());
    return result + wide(in, in.value('r')) + plus_constant(in.constant());
}

Text alu_register(const Instruction& in) {
    const bool three = in.has('o');
    const unsigned code = three ? in.value('o') : in.value('a');
    const Text d = wide(in, in.value('d')), u = wide(in, in.value('u'));
    const Text other = three ? wide(in, in.value('v')) : d;
    const Text sign = joined(" ", Text(alu_signs[code]), " ");
    const Text when = in.has('k') ? condition(in, 'k') : "";
    switch (static_cast<Alu>(code)) {
        case Alu::compare:
        case Alu::test:
            return when + d + sign + u;
        case Alu::negate:
            return when + d + " = -" + u;
        case Alu::subtract_from:
            return when + d + " = " + u + sign + other;
        default:
            break;
    }
    if (!alu_endings[code].empty()) return when + d + " = " + u + " " + Text(alu_endings[code]);
    return when + d + " = " + other + sign + u;
}

Text alu_constant(const Instruction& in) {
    const unsigned code = in.value('h');
    const Text d = wide(in, in.value('d'));
    const Text sign = joined(" ", Text(alu_signs[code]), " ");
    switch (static_cast<Alu>(code)) {
        case Alu::compare:
            return d + sign + signed_constant(in.constant());
        case Alu::test:
            return d + sign + hexadecimal(in.value('i'), 4);
        case Alu::subtract_from:
            return d + " = " + signed_constant(in.constant()) + sign + d;
        case Alu::add_reversed:
            return d + " = " + d + sign + signed_constant(in.constant());
        case Alu::subtract:
            return d + " = " + d + sign + hexadecimal(in.value('i'));
        default:
            return d + " = " + d + sign + hexadecimal(in.value('i'), 4);
    }
}

Text pointer(const Instruction& in) {
    const Text memory = joined("*", name(in.value('p')));
    const unsigned step = in.value('q');
    if (step == register_zero) return memory;
    if (step == decrement_code || step == increment_code) return memory + name(step);
    return memory + "++" + name(step);
}

Text move(const Instruction& in, Dialect dialect) {
    const Text memory = in.operation() == Operation::move_direct
                            ? joined("*", hexadecimal(address_in(in, dialect), 4))
                            : pointer(in);
    const Text moved = name(in.value('e')) + Text(width_suffixes[in.value('w')]);
    return in.value('T') != 0 ? memory + " = " + moved : moved + " = " + memory;
}

Text control(const Instruction& in, Dialect dialect) {
    switch (in.operation()) {
        case Operation::branch:
            return branch(in, dialect);
        case Operation::loop_branch:
            return joined("if (", name(in.value('j')), "-- >= 0) goto ", target(in, dialect));
        case Operation::call:
        case Operation::call_long:
            return joined("call ", target(in, dialect), " (", name(in.value('l')), ")");
        case Operation::add_constant:
            return add_constant(in);
        case Operation::alu_register:
            return alu_register(in);
        case Operation::alu_constant:
            return alu_constant(in);
        case Operation::move_direct:
        case Operation::move_pointer:
            return move(in, dialect);
        case Operation::do_constant:
            return joined("do ", std::to_string(in.value('K')), ", ",
                          std::to_string(in.value('N')));
        case Operation::do_register:
            return joined("do ", std::to_string(in.value('K')), ", ", name(in.value('j')));
        case Operation::goto_long:
            return joined("goto ", target(in, dialect));
        case Operation::load_long:
            return wide(in, in.value('d')) + " = " + hexadecimal(in.long_constant());
        default:
            return "ireturn";
    }
}

}  // namespace

std::string text_of(const Instruction& instruction, Dialect dialect) {
    if (instruction.operation() <= Operation::special) return DataText{instruction}.text();
    return control(instruction, dialect);
}

std::optional<std::uint32_t> target_of(const Instruction& in, std::uint32_t address,
                                       Dialect dialect) {
    const std::uint32_t addresses = dialect == Dialect::dsp32 ? 0xFFFFU : 0xFF'FFFFU;
    const unsigned base = in.value('b');
    switch (in.operation()) {
        case Operation::branch:
        case Operation::loop_branch:
        case Operation::call:
            if (base == register_zero) return address_in(in, dialect);
            if (base == register_pc)
                return (address + 8 + static_cast<std::uint32_t>(in.constant())) & addresses;
            return std::nullopt;
        case Operation::goto_long:
        case Operation::call_long:
            if (base == register_zero) return in.long_constant();
            if (base == register_pc) return (address + 8 + in.long_constant()) & addresses;
            return std::nullopt;
        default:
            return std::nullopt;
    }
}

std::string text_of(Word word, std::uint32_t address, Dialect dialect, const LabelOf& label_of) {
    const auto instruction = decode(word, dialect);
    if (!instruction) return joined(".word ", hexadecimal(word, 8));
    std::string text = text_of(*instruction, dialect);
    const auto to = target_of(*instruction, address, dialect);
    const std::string label = to ? label_of(*to) : "";
    if (label.empty()) return text;
    const bool relative = instruction->has('b') && instruction->value('b') == register_pc;
    const std::string shown = target(*instruction, dialect);
    const std::size_t start = text.find(relative ? joined("goto ", shown) : shown);
    // There is nothing to replace in a nop, nor in a relative call, which shows what it adds.
    if (start == std::string::npos) return text;
    if (!relative) return text.replace(start, shown.size(), label);
    return text.replace(start, 5 + shown.size(), joined("pcgoto ", label));
}

}  // namespace pxm::dsp32::isa
