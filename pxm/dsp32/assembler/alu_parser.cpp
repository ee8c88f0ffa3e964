#include "pxm/dsp32/assembler/statement.hpp"
#include "pxm/dsp32/isa/names.hpp"

namespace pxm::dsp32::assembler {

namespace {

using isa::Alu;
using isa::Dialect;
using isa::Operation;

class AluParser {
  public:
    explicit AluParser(Statement& in) : in_(in) {}

    std::optional<Word> with_register(RegisterName result) {
        if (in_.cursor.accept("=")) return assignment(result);
        if (in_.cursor.peek().is("-")) return look(result, Alu::compare);
        if (in_.cursor.peek().is("&")) return look(result, Alu::test);
        return in_.cursor.fail("expected \"=\", \"-\" or \"&\", found " + shown(in_.cursor.peek()));
    }
    std::optional<Word> look(RegisterName result, Alu function) {
        in_.cursor.take();
        if (!is_whole(result)) return std::nullopt;
        wide_ = result.suffix == 'e';
        if (const auto other = in_.cursor.accept_register()) return two(function, result, *other);
        return constant_function(function, result);
    }
    bool is_whole(RegisterName name) {
        if (name.suffix == 0 || name.suffix == 'e') return true;
        in_.cursor.fail(in_.start, "arithmetic takes whole registers; h and l are for moves");
        return false;
    }
    std::optional<Word> assignment(RegisterName result) {
        if (in_.cursor.peek().is("*")) return load_instruction(in_, result);
        if (!is_whole(result)) return std::nullopt;
        wide_ = result.suffix == 'e';
        if (in_.cursor.peek().is("-") && register_of(in_.cursor.peek(1).text)) {
            in_.cursor.take();
            const auto source = in_.cursor.accept_register();
            return two(Alu::negate, result, *source);
        }
        if (const auto source = in_.cursor.accept_register()) return of_register(result, *source);
        const Place place = in_.cursor.peek().place;
        const auto constant = in_.cursor.expression();
        if (!constant) return std::nullopt;
        if (!in_.cursor.accept("-")) return load_constant(result, *constant, place);
        const auto other = in_.cursor.accept_register();
        if (!other || other->code != result.code) return same_register();
        return with_constant(Alu::subtract_from, result, *constant, place);
    }
    std::optional<Word> load_constant(RegisterName result, std::int64_t constant, Place place) {
        if (wide_ && (constant < least_16 || constant > most_signed_16)) {
            if (constant < 0 || constant > most_24) return no_constant(constant, place);
            return in_.word(Operation::load_long,
                            {{'d', result.code},
                             {'H', static_cast<unsigned>(constant) >> 16U},
                             {'i', bits_16(constant)}},
                            true);
        }
        return sum_with_constant(result, 0, constant, place);
    }
    std::optional<Word> no_constant(std::int64_t constant, Place place) {
        return in_.cursor.fail(place, "the constant is out of range: " + std::to_string(constant));
    }
    std::optional<Word> same_register() {
        return in_.cursor.fail(in_.start, "here the result has to be one of the operands");
    }
    std::optional<Word> sum_with_constant(RegisterName result, unsigned source,
                                          std::int64_t constant, Place place) {
        if (in_.condition)
            return in_.cursor.fail(in_.start, "with a constant there is no condition");
        if (constant < least_16 || constant > (wide_ ? most_signed_16 : most_16))
            return no_constant(constant, place);
        return in_.word(Operation::add_constant,
                        {{'d', result.code}, {'r', source}, {'i', bits_16(constant)}}, wide_);
    }

    /// rD = rS ...
    std::optional<Word> of_register(RegisterName result, RegisterName source) {
        if (!is_whole(source)) return std::nullopt;
        const Place place = in_.cursor.peek().place;
        if (in_.cursor.at_end()) return sum_with_constant(result, source.code, 0, place);
        const std::string_view sign = in_.cursor.take().text;
        for (unsigned code = 0; code < isa::alu_endings.size(); ++code) {
            const std::string_view ending = isa::alu_endings[code];
            if (ending.substr(0, ending.find(' ')) != sign || ending.empty()) continue;
            const std::int64_t number = ending.back() - '0';
            if (!in_.cursor.expression(number, number, "what stands behind this sign"))
                return std::nullopt;
            return two(static_cast<Alu>(code), result, source);
        }
        const auto function = function_of(sign);
        if (!function) return in_.cursor.fail(place, "expected an operator of the control unit");
        if (const auto other = in_.cursor.accept_register())
            return of_two(*function, result, source, *other);
        return of_constant(*function, result, source);
    }
    static std::optional<Alu> function_of(std::string_view sign) {
        if (sign == "-") return Alu::subtract;
        if (sign == "&") return Alu::conjunction;
        const auto code = isa::code_of(isa::alu_signs, sign);
        if (!code) return std::nullopt;
        return static_cast<Alu>(*code);
    }
    std::optional<Word> of_constant(Alu function, RegisterName result, RegisterName source) {
        const Place place = in_.cursor.peek().place;
        const bool same = source.code == result.code;
        if (function == Alu::add || (function == Alu::subtract && !same)) {
            const auto constant = in_.cursor.expression();
            if (!constant) return std::nullopt;
            return sum_with_constant(result, source.code,
                                     function == Alu::add ? *constant : -*constant, place);
        }
        if (!same) return same_register();
        return constant_function(function, result);
    }
    std::optional<Word> constant_function(Alu function, RegisterName result) {
        const Place place = in_.cursor.peek().place;
        const auto constant = in_.cursor.expression();
        if (!constant) return std::nullopt;
        return with_constant(function, result, *constant, place);
    }
    std::optional<Word> with_constant(Alu function, RegisterName result, std::int64_t constant,
                                      Place place) {
        if (in_.condition)
            return in_.cursor.fail(in_.start, "with a constant there is no condition");
        if (constant < least_16 || constant > most_16) return no_constant(constant, place);
        return in_.word(
            Operation::alu_constant,
            {{'h', static_cast<unsigned>(function)}, {'d', result.code}, {'i', bits_16(constant)}},
            wide_);
    }
    /// rD = rA op rB.
    std::optional<Word> of_two(Alu function, RegisterName result, RegisterName first,
                               RegisterName second) {
        if (result.code == first.code) return two(function, result, second);
        const bool last = result.code == second.code;
        if (last && function == Alu::subtract) return two(Alu::subtract_from, result, first);
        if (in_.around.dialect == Dialect::dsp32c) return three(function, result, first, second);
        // Sums and logic do not mind the order.
        if (!last || function == Alu::and_not) return same_register();
        return two(function, result, first);
    }
    std::optional<Word> two(Alu function, RegisterName result, RegisterName other) {
        if (!is_whole(other)) return std::nullopt;
        const auto code = static_cast<unsigned>(function);
        if (!in_.condition)
            return in_.word(Operation::alu_register,
                            {{'a', code}, {'d', result.code}, {'u', other.code}}, wide_);
        return in_.word(Operation::alu_register,
                        {{'a', code}, {'d', result.code}, {'u', other.code}, {'k', *in_.condition}},
                        wide_);
    }
    std::optional<Word> three(Alu function, RegisterName result, RegisterName first,
                              RegisterName second) {
        if (!is_whole(first) || !is_whole(second)) return std::nullopt;
        const auto code = static_cast<unsigned>(function);
        if (!in_.condition)
            return in_.word(
                Operation::alu_register,
                {{'o', code}, {'d', result.code}, {'u', second.code}, {'v', first.code}}, wide_);
        return in_.word(Operation::alu_register,
                        {{'o', code},
                         {'d', result.code},
                         {'u', second.code},
                         {'v', first.code},
                         {'k', *in_.condition}},
                        wide_);
    }

    Statement& in_;
    bool wide_ = false;
};

}  // namespace

std::optional<Word> register_instruction(Statement& in, RegisterName result) {
    return AluParser(in).with_register(result);
}

}  // namespace pxm::dsp32::assembler
