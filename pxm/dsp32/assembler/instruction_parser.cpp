#include "pxm/dsp32/assembler/instruction_parser.hpp"

#include <algorithm>
#include <array>

#include "pxm/dsp32/assembler/data_parser.hpp"
#include "pxm/dsp32/assembler/statement.hpp"
#include "pxm/dsp32/isa/names.hpp"

namespace pxm::dsp32::assembler {

namespace {

constexpr std::array<std::string_view, 6> branch_keywords{"goto",   "pcgoto", "call",
                                                          "return", "if",     "do"};

bool is_branch_keyword(std::string_view name) {
    return std::ranges::find(branch_keywords, name) != branch_keywords.end();
}

std::optional<Word> word_of(Statement& in) {
    Cursor& cursor = in.cursor;
    const Token& token = cursor.peek();
    if (token.is("*")) return store_instruction(in);
    if (accumulator_of(token.text))
        return data_instruction(cursor, in.around.dialect, std::nullopt);
    if (isa::code_of(isa::port_names, token.text)) return port_instruction(in);
    if (const auto result = cursor.accept_register()) return register_instruction(in, *result);
    if (cursor.accept("nop")) return isa::nop;
    if (cursor.accept("ireturn")) return in.word(isa::Operation::interrupt_return, {});
    if (!is_branch_keyword(token.text)) return cursor.fail("unknown instruction " + shown(token));
    return branch_instruction(in, cursor.take().text);
}

}  // namespace

bool is_reserved(std::string_view name) {
    return name == "nop" || name == "ireturn" || is_branch_keyword(name) || register_of(name) ||
           accumulator_of(name) || isa::code_of(isa::port_names, name).has_value();
}

std::string no_such_instruction(isa::Operation operation, bool wide, isa::FieldValues values) {
    if (isa::word_of_fields(operation, wide, isa::Dialect::dsp32c, values))
        return "only the DSP32C has this instruction";
    return "there is no such instruction";
}

std::optional<Word> Statement::word(isa::Operation operation, isa::FieldValues values, bool wide) {
    const auto word = isa::word_of_fields(operation, wide, around.dialect, values);
    if (!word) cursor.fail(start, no_such_instruction(operation, wide, values));
    return word;
}

std::optional<Word> instruction_word(Cursor& cursor, const Surroundings& around) {
    Statement in{cursor, around, cursor.peek().place, {}};
    const auto word = word_of(in);
    if (!word || cursor.failed() || !cursor.expect_end()) return std::nullopt;
    return word;
}

}  // namespace pxm::dsp32::assembler
