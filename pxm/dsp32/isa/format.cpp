#include "pxm/dsp32/isa/format.hpp"

namespace pxm::dsp32::isa {

namespace {

using enum Operation;
using enum Certainty;
constexpr Dialect first = Dialect::dsp32;
constexpr Dialect later = Dialect::dsp32c;

constexpr Format row(std::string_view name, Operation operation, std::string_view pattern,
                     Dialect since, Certainty certainty, bool wide = false) {
    Format format{name, operation, pattern, since, certainty, wide};
    char open = 0;
    int bit = 31;
    for (const char c : pattern) {
        if (c == ' ') continue;
        if (c == '0' || c == '1') {
            format.fixed_mask |= Word{1} << bit;
            if (c == '1') format.fixed_bits |= Word{1} << bit;
        } else {
            // A constant of 24 bits has its halves apart, with different letters.
            if (c != open)
                format.fields[static_cast<std::size_t>(format.field_count++)] = {c, 0, 0};
            Field& field = format.fields[static_cast<std::size_t>(format.field_count - 1)];
            field.low_bit = bit;
            ++field.bits;
        }
        open = c;
        --bit;
    }
    return format;
}

// clang-format off
constexpr std::array table{
    // name, operation, pattern, since, mark
    row("DA 1",  add_product,     "0010mm0f snnxxxxx xxyyyyyy yzzzzzzz", first, derived),
    row("DA 1",  copy,            "0011000f 0nn00000 00yyyyyy yzzzzzzz", first, derived),
    row("DA 1",  add,             "0011010f snnxxxxx xxyyyyyy yzzzzzzz", first, derived),
    row("DA 4",  tap_add,         "0011100f snnxxxxx xxyyyyyy yttttttt", first, derived),
    row("DA 2",  tap_product_add, "0100mm0f snnxxxxx xxyyyyyy yttttttt", first, derived),
    row("DA 2",  tap_product,     "01010000 snnxxxxx xxyyyyyy yttttttt", first, derived),
    row("DA 2",  tap_product_one, "0101010f snnxxxxx xxyyyyyy yttttttt", first, derived),
    row("DA 3",  product_add,     "0110mm0f snnxxxxx xxyyyyyy yzzzzzzz", first, derived),
    row("DA 3",  product,         "01110000 snnxxxxx xxyyyyyy yzzzzzzz", first, derived),
    row("DA 3",  product_one,     "0111010f snnxxxxx xxyyyyyy yzzzzzzz", first, derived),
    row("DA 5",  special,         "01111ggg gnn00000 00yyyyyy yzzzzzzz", first, derived),
    row("CA 0",  branch,          "00000ccc cccbbbbb iiiiiiii iiiiiiii", first, derived),
    row("CA 3a", loop_branch,     "000011jj jjjbbbbb iiiiiiii iiiiiiii", first, derived),
    row("CA 4",  call,            "000100ll lllbbbbb iiiiiiii iiiiiiii", first, derived),
    row("CA 5a", add_constant,    "000101dd dddrrrrr iiiiiiii iiiiiiii", first, derived),
    row("CA 6a", alu_register,    "0001100a aaaddddd 000000uu uuu00000", first, derived),
    row("CA 6c", alu_constant,    "0001101h hhhddddd iiiiiiii iiiiiiii", first, derived),
    row("CA 7a", move_direct,     "0001110T ww0eeeee iiiiiiii iiiiiiii", first, derived),
    row("CA 7b", move_pointer,    "0001111T ww0eeeee 000000pp pppqqqqq", first, derived),
    // Three operands and conditions take bits that two operands leave unused: taken for additions.
    row("CA 6a", alu_register,    "0001100a aaaddddd kkkk01uu uuu00000", later, assumed),
    row("CA 6a", alu_register,    "0001100o oooddddd 000010uu uuuvvvvv", later, assumed),
    row("CA 6a", alu_register,    "0001100o oooddddd kkkk11uu uuuvvvvv", later, assumed),
    // Bit 31 makes 24 bits of 16, and the first DSP32 had 16.
    row("CA 5b", add_constant,    "100101dd dddrrrrr iiiiiiii iiiiiiii", later, recalled, true),
    row("CA 6b", alu_register,    "1001100a aaaddddd 000000uu uuu00000", later, recalled, true),
    row("CA 6b", alu_register,    "1001100a aaaddddd kkkk01uu uuu00000", later, recalled, true),
    row("CA 6b", alu_register,    "1001100o oooddddd 000010uu uuuvvvvv", later, recalled, true),
    row("CA 6b", alu_register,    "1001100o oooddddd kkkk11uu uuuvvvvv", later, recalled, true),
    row("CA 6d", alu_constant,    "1001101h hhhddddd iiiiiiii iiiiiiii", later, recalled, true),
    row("CA 8a", goto_long,       "101HHHHH HHHbbbbb iiiiiiii iiiiiiii", later, recalled, true),
    row("CA 8b", load_long,       "110HHHHH HHHddddd iiiiiiii iiiiiiii", later, recalled, true),
    row("CA 8c", call_long,       "111HHHHH HHHlllll iiiiiiii iiiiiiii", later, recalled, true),
    row("CA 3b", do_constant,     "10001100 000KKKKK 00000NNN NNNNNNNN", later, recalled),
    row("CA 3c", do_register,     "10001100 001KKKKK 00000000 000jjjjj", later, recalled),
    row("CA 0",  interrupt_return,"00000000 00111110 00000000 00000000", later, recalled),
};

constexpr std::array<Addition, 5> added{{
    {"g", 8, 14, derived, "24-bit conversions, IEEE conversions, seed: beyond the three bits of the first eight functions"},
    {"w", 3, 3, recalled, "moves of 24 bits"},
    {"c", 44, 47, recalled, "conditions of interrupt requests"},
    {"drebljuv", 29, 29, recalled, "r22, the interrupt vector table"},
    {"re", 30, 30, recalled, "pcsh, where an interrupt returns to"},
}};
// clang-format on

constexpr bool is_general(unsigned code) {  // r1 to r14, r15 to r19, r20, r21, r22
    return (code >= 1 && code <= 14) || (code >= 17 && code <= 21) || code == 24 || code == 25 ||
           code == 29;
}
constexpr unsigned code_pc = 15, code_dauc = 26, code_ioc = 27, code_pcsh = 30;

constexpr bool is_control(unsigned code) { return code == code_dauc || code == code_ioc; }

constexpr bool operand_allows(char letter, unsigned value) {
    const unsigned pointer = value >> 3U, index = value & 7U;
    if (pointer == 15) return false;  // the sources contradict each other (docs/dsp32.md)
    if (pointer != 0) return true;
    if (letter == 'z' || letter == 't')
        return (index >= 4 && index <= 6) || (letter == 'z' && index == 7);
    return index <= 6;  // an accumulator or a port
}

/// Functions of two operands, of three, and with a constant, as sets of the 16 codes.
constexpr unsigned two_operands = 0xFFFF;
constexpr unsigned three_operands = 0b0100'0101'0101'1101;
constexpr unsigned with_constant = 0b1100'0101'1101'1100;

constexpr bool defined(char letter, unsigned value) {
    switch (letter) {
        case 'x':
        case 'y':
        case 'z':
        case 't':
            return operand_allows(letter, value);
        case 'g':
            return value <= 7 || (value >= 10 && value <= 14);
        case 'c':
            return value <= 25 || (value >= 32 && value <= 47);
        case 'b':
            return value == 0 || value == code_pc || is_general(value);
        case 'l':
        case 'j':
        case 'u':
        case 'v':
            return is_general(value);
        case 'd':
            return is_general(value) || is_control(value);
        case 'r':
            return value == 0 || value == code_pc || value == code_pcsh || is_general(value) ||
                   is_control(value);
        case 'e':
            return is_general(value) || is_control(value) || value == code_pcsh;
        case 'a':
            return (two_operands >> value & 1U) != 0;
        case 'o':
            return (three_operands >> value & 1U) != 0;
        case 'h':
            return (with_constant >> value & 1U) != 0;
        case 'p':
            return value >= 1 && value <= 14;
        case 'q':
            return value <= 14 || (value >= 17 && value <= 23);
        default:
            return true;
    }
}

}  // namespace

std::span<const Format> formats() noexcept { return table; }
std::span<const Addition> additions() noexcept { return added; }

bool field_allows(char letter, unsigned value, Dialect dialect) noexcept {
    if (!defined(letter, value)) return false;
    if (dialect == later) return true;
    for (const Addition& addition : added) {
        if (addition.letters.find(letter) != std::string_view::npos && value >= addition.first &&
            value <= addition.last)
            return false;
    }
    return true;
}

}  // namespace pxm::dsp32::isa
