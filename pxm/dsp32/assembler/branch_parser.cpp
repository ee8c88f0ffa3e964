#include "pxm/dsp32/assembler/statement.hpp"
#include "pxm/dsp32/isa/names.hpp"

namespace pxm::dsp32::assembler {

namespace {

using isa::Dialect;
using isa::Operation;

/// Where a branch leads: a register (0: none, then the constant is an address) and a constant.
struct Target {
    unsigned base = 0;
    std::int64_t constant = 0;
    Place place;
};

class BranchParser {
  public:
    explicit BranchParser(Statement& in) : in_(in) {}

    std::optional<Word> parse(std::string_view keyword) {
        if (keyword == "goto") return branch(isa::condition_true, absolute_target());
        if (keyword == "pcgoto") return branch(isa::condition_true, relative_target());
        if (keyword == "return") return return_by();
        if (keyword == "call") return call();
        if (keyword == "do") return loop();
        return conditional();
    }

  private:
    std::optional<Target> absolute_target() {
        const Place place = in_.cursor.peek().place;
        const auto base = in_.cursor.accept_register();
        if (base && base->suffix != 0) return in_.cursor.fail(place, "expected a whole register");
        if (base && !in_.cursor.peek().is("+") && !in_.cursor.peek().is("-"))
            return Target{base->code, 0, place};
        const auto constant = in_.cursor.expression();  // a sign is that of the constant
        if (!constant) return std::nullopt;
        return Target{base ? base->code : 0, *constant, place};
    }
    std::optional<Target> relative_target() {
        const Place place = in_.cursor.peek().place;
        const auto to = in_.cursor.expression();
        if (!to) return std::nullopt;
        return Target{isa::register_pc, *to - in_.around.address - 8, place};
    }
    /// Whether the instruction there, if its address is known, belongs to the program.
    bool leads_into_program(const Target& target) {
        if (target.base != 0 && target.base != isa::register_pc) return true;
        // Addresses have 16 bits, or 24, and wrap.
        const std::int64_t addresses = in_.around.dialect == Dialect::dsp32 ? most_16 : most_24;
        const std::int64_t from = target.base == 0 ? 0 : std::int64_t{in_.around.address} + 8;
        const std::int64_t to = (from + target.constant) & addresses;
        if (to < in_.around.program_bytes && to % 4 == 0) return true;
        in_.cursor.fail(target.place, "a branch to " + std::to_string(to) +
                                          ": the program's instructions are at 0 to " +
                                          std::to_string(in_.around.program_bytes - 4) +
                                          ", by four");
        return false;
    }
    /// Whether 16 bits hold the constant: as an address, or with a sign.
    [[nodiscard]] bool is_short(const Target& target) const {
        if (in_.around.dialect == Dialect::dsp32 && target.base != isa::register_pc)
            return target.constant >= least_16 && target.constant <= most_16;
        if (target.base == 0 && target.constant >= most_24 - most_signed_16) return true;
        return target.constant >= least_16 && target.constant <= most_signed_16;
    }
    std::optional<Word> out_of_reach(const Target& target) {
        return in_.cursor.fail(
            target.place, "too far: " + std::to_string(target.constant) + " does not fit 16 bits");
    }
    std::optional<Word> branch(unsigned condition, const std::optional<Target>& target) {
        if (!target || !leads_into_program(*target)) return std::nullopt;
        if (is_short(*target))
            return in_.word(
                Operation::branch,
                {{'c', condition}, {'b', target->base}, {'i', bits_16(target->constant)}});
        if (in_.around.dialect == Dialect::dsp32 || condition != isa::condition_true ||
            target->constant < 0 || target->constant > most_24)
            return out_of_reach(*target);
        return in_.word(Operation::goto_long,
                        {{'b', target->base},
                         {'H', static_cast<unsigned>(target->constant) >> 16U},
                         {'i', bits_16(target->constant)}},
                        true);
    }
    std::optional<unsigned> link_register() {
        if (!in_.cursor.expect("(")) return std::nullopt;
        const auto link = in_.cursor.accept_register();
        if (!link || link->suffix != 0) return in_.cursor.fail("expected a register");
        if (!in_.cursor.expect(")")) return std::nullopt;
        return link->code;
    }
    std::optional<Word> return_by() {
        const auto link = link_register();
        if (!link) return std::nullopt;
        return in_.word(Operation::branch, {{'c', isa::condition_true}, {'b', *link}});
    }
    std::optional<Word> call() {
        const auto target = absolute_target();
        if (!target || !leads_into_program(*target)) return std::nullopt;
        const auto link = link_register();
        if (!link) return std::nullopt;
        if (is_short(*target))
            return in_.word(Operation::call,
                            {{'l', *link}, {'b', target->base}, {'i', bits_16(target->constant)}});
        if (in_.around.dialect == Dialect::dsp32 || target->base != 0 || target->constant < 0 ||
            target->constant > most_24)
            return out_of_reach(*target);
        return in_.word(Operation::call_long,
                        {{'l', *link},
                         {'H', static_cast<unsigned>(target->constant) >> 16U},
                         {'i', bits_16(target->constant)}},
                        true);
    }
    std::optional<Target> branch_target() {
        if (in_.cursor.accept("pcgoto")) return relative_target();
        if (!in_.cursor.expect("goto")) return std::nullopt;
        return absolute_target();
    }
    std::optional<Word> conditional() {
        if (!in_.cursor.expect("(")) return std::nullopt;
        if (const auto counter = in_.cursor.accept_register()) return loop_branch(*counter);
        const Token& name = in_.cursor.take();
        const auto condition = isa::code_of(isa::condition_names, name.text);
        if (!condition) return in_.cursor.fail(name.place, "unknown condition " + shown(name));
        if (!in_.cursor.expect(")")) return std::nullopt;
        if (in_.cursor.peek().is("goto") || in_.cursor.peek().is("pcgoto"))
            return branch(*condition, branch_target());
        constexpr unsigned alu_conditions = 16;
        if (*condition >= alu_conditions)
            return in_.cursor.fail(name.place, "this condition is one of branches only");
        in_.condition = *condition;
        const auto result = in_.cursor.accept_register();
        if (!result)
            return in_.cursor.fail("expected goto, or a register, found " +
                                   shown(in_.cursor.peek()));
        return register_instruction(in_, *result);
    }
    std::optional<Word> loop_branch(RegisterName counter) {
        if (!in_.cursor.expect("--") || !in_.cursor.expect(">=")) return std::nullopt;
        const auto zero = in_.cursor.expression(0, 0, "what the counter is compared with");
        if (!zero || !in_.cursor.expect(")")) return std::nullopt;
        const auto target = branch_target();
        if (!target || !leads_into_program(*target)) return std::nullopt;
        if (!is_short(*target)) return out_of_reach(*target);
        return in_.word(
            Operation::loop_branch,
            {{'j', counter.code}, {'b', target->base}, {'i', bits_16(target->constant)}});
    }
    std::optional<Word> loop() {
        const auto length = in_.cursor.expression(0, 31, "the length of a loop");
        if (!length || !in_.cursor.expect(",")) return std::nullopt;
        const auto instructions = static_cast<unsigned>(*length);
        if (const auto counter = in_.cursor.accept_register())
            return in_.word(Operation::do_register, {{'K', instructions}, {'j', counter->code}});
        const auto count = in_.cursor.expression(0, 2047, "the count of a loop");
        if (!count) return std::nullopt;
        return in_.word(Operation::do_constant,
                        {{'K', instructions}, {'N', static_cast<unsigned>(*count)}});
    }

    Statement& in_;
};

}  // namespace

std::optional<Word> branch_instruction(Statement& in, std::string_view keyword) {
    return BranchParser(in).parse(keyword);
}

}  // namespace pxm::dsp32::assembler
