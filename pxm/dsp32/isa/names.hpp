// The words of the published assembler syntax: registers, conditions, functions, ports.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace pxm::dsp32::isa {

/// Registers of the control unit by their code of five bits, which has gaps: after r14 comes the
/// program counter, and two codes are no registers but the increments -- and ++ (S7, S8).
inline constexpr std::array<std::string_view, 32> register_names{
    "0",   "r1",  "r2",  "r3",  "r4",   "r5",  "r6",  "r7",  "r8",   "r9",  "r10",
    "r11", "r12", "r13", "r14", "pc",   "",    "r15", "r16", "r17",  "r18", "r19",
    "--",  "++",  "r20", "r21", "dauc", "ioc", "",    "r22", "pcsh", ""};

inline constexpr unsigned register_zero = 0;    // always 0
inline constexpr unsigned register_pc = 15;     // the program counter
inline constexpr unsigned register_r15 = 17;    // r15, behind the gap
inline constexpr unsigned decrement_code = 22;  // --
inline constexpr unsigned increment_code = 23;  // ++
inline constexpr unsigned register_dauc = 26;   // control of the data unit
inline constexpr unsigned register_ioc = 27;    // control of the ports
inline constexpr unsigned register_count = 32;  // codes

/// Conditions of branches by their code; ALU instructions have the first sixteen.
inline constexpr std::array<std::string_view, 48> condition_names{
    "false", "true", "pl",  "mi",  "ne",       "eq",       "vc",       "vs",      "cc",  "cs",
    "ge",    "lt",   "gt",  "le",  "hi",       "ls",       "auc",      "aus",     "age", "alt",
    "ane",   "aeq",  "avc", "avs", "agt",      "ale",      "",         "",        "",    "",
    "",      "",     "ibe", "ibf", "obf",      "obe",      "pde",      "pdf",     "pie", "pif",
    "syc",   "sys",  "fbc", "fbs", "ireq1_lo", "ireq1_hi", "ireq2_lo", "ireq2_hi"};
inline constexpr unsigned condition_true = 1;  // of a branch that is always taken

/// Special functions of the data unit by their code.
inline constexpr std::array<std::string_view, 16> function_names{
    "ic", "oc", "float",   "int",   "round", "ifalt", "ifaeq", "ifagt",
    "",   "",   "float24", "int24", "ieee",  "dsp",   "seed",  ""};

/// Ports of the data unit by the code that stands where an accumulator's number would.
inline constexpr std::array<std::string_view, 8> port_names{"",     "",     "",    "",
                                                            "ibuf", "obuf", "pdr", ""};

/// Widths of a move: the high or the low byte of a register, its 16 bits, all of its 24.
inline constexpr std::array<std::string_view, 4> width_suffixes{"h", "l", "", "e"};

/// What the ALU does, by its code of four bits.
enum class Alu : unsigned {
    add,
    twice,
    subtract_from,
    add_reversed,
    subtract,
    negate,
    and_not,
    compare,
    exclusive_or,
    rotate_right,
    inclusive_or,
    rotate_left,
    shift_right,
    half,
    conjunction,
    test,
};
/// Between the operands of a function of two; empty for the functions of one.
inline constexpr std::array<std::string_view, 16> alu_signs{"+", "", "-", "#", "-", "", "&~", "-",
                                                            "^", "", "|", "",  "",  "", "&",  "&"};
/// After the operand of a function of one; empty for the others.
inline constexpr std::array<std::string_view, 16> alu_endings{
    "", "* 2", "", "", "", "", "", "", "", ">>> 1", "", "<<< 1", ">> 1", "/ 2", "", ""};

/// The code of a name in a table; empty names are no names.
template <std::size_t n>
[[nodiscard]] constexpr std::optional<unsigned> code_of(
    const std::array<std::string_view, n>& names, std::string_view name) noexcept {
    if (name.empty()) return std::nullopt;
    for (std::size_t i = 0; i < n; ++i)
        if (names[i] == name) return static_cast<unsigned>(i);
    return std::nullopt;
}

}  // namespace pxm::dsp32::isa
