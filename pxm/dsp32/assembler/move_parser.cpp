#include "pxm/dsp32/assembler/data_parser.hpp"
#include "pxm/dsp32/assembler/statement.hpp"
#include "pxm/dsp32/isa/names.hpp"

namespace pxm::dsp32::assembler {

namespace {

using isa::Dialect;
using isa::Operation;

class MoveParser {
  public:
    explicit MoveParser(Statement& in) : in_(in) {}

    std::optional<Word> store_to_port() {
        const auto z = data_operand(in_.cursor, Access::write);
        if (!z || !in_.cursor.expect("=")) return std::nullopt;
        return data_instruction(in_.cursor, in_.around.dialect, z);
    }
    /// *rP++ = aN = ..., *rP++ = rN, or *address = rN.
    std::optional<Word> store() {
        const Token& behind = in_.cursor.peek(1);
        if (behind.kind != TokenKind::name || !register_of(behind.text)) return store_direct();
        Cursor ahead = in_.cursor;
        const auto memory = memory_operand(in_.cursor);
        if (!memory || !in_.cursor.expect("=")) return std::nullopt;
        if (accumulator_of(in_.cursor.peek().text)) {
            const auto z = data_operand(ahead, Access::write);
            if (!z) return std::nullopt;
            return data_instruction(in_.cursor, in_.around.dialect, z);
        }
        const auto moved = moved_register();
        if (!moved) return std::nullopt;
        return move_at_pointer(1, *moved, *memory);
    }
    std::optional<Word> store_direct() {
        in_.cursor.take();
        const auto address = memory_address();
        if (!address || !in_.cursor.expect("=")) return std::nullopt;
        const auto moved = moved_register();
        if (!moved) return std::nullopt;
        return move_direct(1, *moved, *address);
    }
    std::optional<RegisterName> moved_register() {
        const auto moved = in_.cursor.accept_register();
        if (!moved)
            return in_.cursor.fail("expected a register or an accumulator, found " +
                                   shown(in_.cursor.peek()));
        return moved;
    }
    std::optional<std::int64_t> memory_address() {
        if (in_.around.dialect == Dialect::dsp32)
            return in_.cursor.expression(0, most_16, "an address");
        const auto address = in_.cursor.expression(0, most_24, "an address");
        if (!address) return std::nullopt;
        if (*address > most_signed_16 && *address < most_24 - most_signed_16)
            return in_.cursor.fail("this address does not fit 16 bits with a sign");
        return address;
    }
    static unsigned width(char suffix) {
        const std::string_view text = suffix == 0 ? "" : std::string_view(&suffix, 1);
        for (unsigned i = 0; i < isa::width_suffixes.size(); ++i)
            if (isa::width_suffixes[i] == text) return i;
        return 0;
    }
    std::optional<Word> move_direct(unsigned out, RegisterName moved, std::int64_t address) {
        return in_.word(
            Operation::move_direct,
            {{'T', out}, {'w', width(moved.suffix)}, {'e', moved.code}, {'i', bits_16(address)}});
    }
    std::optional<Word> move_at_pointer(unsigned out, RegisterName moved, Memory memory) {
        return in_.word(Operation::move_pointer, {{'T', out},
                                                  {'w', width(moved.suffix)},
                                                  {'e', moved.code},
                                                  {'p', memory.pointer},
                                                  {'q', memory.step}});
    }
    std::optional<Word> load(RegisterName result) {
        const Token& behind = in_.cursor.peek(1);
        if (behind.kind == TokenKind::name && register_of(behind.text)) {
            const auto memory = memory_operand(in_.cursor);
            if (!memory) return std::nullopt;
            return move_at_pointer(0, result, *memory);
        }
        in_.cursor.take();
        const auto address = memory_address();
        if (!address) return std::nullopt;
        return move_direct(0, result, *address);
    }

    Statement& in_;
};

}  // namespace

std::optional<Word> store_instruction(Statement& in) { return MoveParser(in).store(); }
std::optional<Word> load_instruction(Statement& in, RegisterName result) {
    return MoveParser(in).load(result);
}
std::optional<Word> port_instruction(Statement& in) { return MoveParser(in).store_to_port(); }

}  // namespace pxm::dsp32::assembler
