#include "pxm/dsp32/assembler/data_parser.hpp"

#include "pxm/dsp32/assembler/instruction_parser.hpp"
#include "pxm/dsp32/isa/names.hpp"

namespace pxm::dsp32::assembler {

namespace {

using isa::Operation;

constexpr std::string_view forms =
    "this is no form of the data unit; there are Y, Y + X, Y * X, Y + aM * X, aM + Y * X, "
    "1.0 + Y * X, each with signs, and function(Y)";

/// A factor or a summand.
struct Term {
    enum class Kind : std::uint8_t { operand, one } kind = Kind::operand;
    unsigned field = 0;           // of seven bits
    std::optional<unsigned> tap;  // (Z = Y): the field of Z

    [[nodiscard]] bool is_accumulator() const { return kind == Kind::operand && field < 4 && !tap; }
    [[nodiscard]] bool is_plain() const { return kind == Kind::operand && !tap; }
};

/// [-] a [* b] [+- c [* d]]
struct Sum {
    bool minus = false;
    Term a;
    std::optional<Term> b;
    bool minus_second = false;
    std::optional<Term> c;
    std::optional<Term> d;
};

class DataParser {
  public:
    DataParser(Cursor& cursor, isa::Dialect dialect, std::optional<unsigned> z)
        : cursor_(cursor), dialect_(dialect), z_(z) {}

    std::optional<Word> parse() {
        const Place start = cursor_.peek().place;
        const auto result = accumulator_of(cursor_.take().text);
        if (!result) return cursor_.fail(start, "expected an accumulator, a0 to a3");
        n_ = *result;
        if (!cursor_.expect("=")) return std::nullopt;
        const auto function = isa::code_of(isa::function_names, cursor_.peek().text);
        const auto word = function ? special(*function) : sum();
        if (!word || !cursor_.expect_end()) return std::nullopt;
        return word;
    }

  private:
    std::optional<Word> special(unsigned function) {
        const Place place = cursor_.take().place;
        if (!cursor_.expect("(")) return std::nullopt;
        const auto y = data_operand(cursor_, Access::read);
        if (!y || !cursor_.expect(")")) return std::nullopt;
        return word(place, Operation::special, {{'g', function}, {'n', n_}, {'y', *y}, {'z', z()}});
    }

    [[nodiscard]] unsigned z() const { return z_.value_or(no_write); }

    std::optional<Word> word(Place place, Operation operation, isa::FieldValues values) {
        const auto word = isa::word_of_fields(operation, false, dialect_, values);
        if (!word) return cursor_.fail(place, no_such_instruction(operation, false, values));
        return word;
    }

    std::optional<Term> term() {
        const Token& token = cursor_.peek();
        if ((token.kind == TokenKind::real || token.kind == TokenKind::integer) &&
            token.real == 1) {
            cursor_.take();
            return Term{Term::Kind::one, 0, {}};
        }
        if (cursor_.accept("(")) {
            const auto to = data_operand(cursor_, Access::write);
            if (!to || !cursor_.expect("=")) return std::nullopt;
            const auto y = data_operand(cursor_, Access::read);
            if (!y || !cursor_.expect(")")) return std::nullopt;
            return Term{Term::Kind::operand, *y, *to};
        }
        const auto field = data_operand(cursor_, Access::read);
        if (!field) return std::nullopt;
        return Term{Term::Kind::operand, *field, {}};
    }

    std::optional<Word> sum() {
        const Place start = cursor_.peek().place;
        Sum s;
        s.minus = cursor_.accept("-");
        const auto a = term();
        if (!a) return std::nullopt;
        s.a = *a;
        if (cursor_.accept("*")) {
            s.b = term();
            if (!s.b) return std::nullopt;
            return product(s, start);
        }
        if (cursor_.at_end()) return copy(s, start);
        s.minus_second = cursor_.peek().is("-");
        if (!cursor_.accept("-") && !cursor_.expect("+")) return std::nullopt;
        s.c = term();
        if (!s.c) return std::nullopt;
        if (!cursor_.accept("*")) return two_terms(s, start);
        s.d = term();
        if (!s.d) return std::nullopt;
        return with_product(s, start);
    }

    std::optional<Word> no_form(Place place) { return cursor_.fail(place, std::string(forms)); }

    std::optional<Word> copy(const Sum& s, Place place) {
        if (!s.a.is_plain()) return no_form(place);
        return word(place, Operation::copy,
                    {{'f', s.minus}, {'n', n_}, {'y', s.a.field}, {'z', z()}});
    }

    std::optional<Word> product(const Sum& s, Place place) {
        if (s.a.kind != Term::Kind::operand || !s.b->is_plain()) return no_form(place);
        if (!s.a.tap)
            return word(
                place, Operation::product,
                {{'s', s.minus}, {'n', n_}, {'x', s.b->field}, {'y', s.a.field}, {'z', z()}});
        if (z_) return twice_written(place);
        return word(
            place, Operation::tap_product,
            {{'s', s.minus}, {'n', n_}, {'x', s.b->field}, {'y', s.a.field}, {'t', *s.a.tap}});
    }

    std::optional<Word> two_terms(const Sum& s, Place place) {
        if (s.a.kind != Term::Kind::operand || !s.c->is_plain()) return no_form(place);
        if (!s.a.tap)
            return word(place, Operation::add,
                        {{'f', s.minus},
                         {'s', s.minus_second},
                         {'n', n_},
                         {'x', s.c->field},
                         {'y', s.a.field},
                         {'z', z()}});
        if (z_) return twice_written(place);
        return word(place, Operation::tap_add,
                    {{'f', s.minus},
                     {'s', s.minus_second},
                     {'n', n_},
                     {'x', s.c->field},
                     {'y', s.a.field},
                     {'t', *s.a.tap}});
    }

    std::optional<Word> with_product(const Sum& s, Place place) {
        if (!s.d->is_plain() || s.c->kind != Term::Kind::operand) return no_form(place);
        if (s.c->tap && z_) return twice_written(place);
        if (s.a.kind == Term::Kind::one) return one_and_product(s, place);
        if (s.a.is_accumulator()) {
            if (s.c->tap)
                return word(place, Operation::tap_product_add,
                            {{'m', s.a.field},
                             {'f', s.minus},
                             {'s', s.minus_second},
                             {'n', n_},
                             {'x', s.d->field},
                             {'y', s.c->field},
                             {'t', *s.c->tap}});
            return word(place, Operation::product_add,
                        {{'m', s.a.field},
                         {'f', s.minus},
                         {'s', s.minus_second},
                         {'n', n_},
                         {'x', s.d->field},
                         {'y', s.c->field},
                         {'z', z()}});
        }
        if (!s.a.is_plain() || !s.c->is_accumulator()) return no_form(place);
        return word(place, Operation::add_product,
                    {{'m', s.c->field},
                     {'f', s.minus},
                     {'s', s.minus_second},
                     {'n', n_},
                     {'x', s.d->field},
                     {'y', s.a.field},
                     {'z', z()}});
    }

    std::optional<Word> one_and_product(const Sum& s, Place place) {
        if (s.c->tap)
            return word(place, Operation::tap_product_one,
                        {{'f', s.minus},
                         {'s', s.minus_second},
                         {'n', n_},
                         {'x', s.d->field},
                         {'y', s.c->field},
                         {'t', *s.c->tap}});
        return word(place, Operation::product_one,
                    {{'f', s.minus},
                     {'s', s.minus_second},
                     {'n', n_},
                     {'x', s.d->field},
                     {'y', s.c->field},
                     {'z', z()}});
    }

    std::optional<Word> twice_written(Place place) {
        return cursor_.fail(place, "an instruction writes memory once");
    }

    static constexpr unsigned no_write = 7;

    Cursor& cursor_;
    isa::Dialect dialect_;
    std::optional<unsigned> z_;
    unsigned n_ = 0;
};

}  // namespace

std::optional<Memory> memory_operand(Cursor& cursor) {
    if (!cursor.expect("*")) return std::nullopt;
    const Place place = cursor.peek().place;
    const auto pointer = cursor.accept_register();
    if (!pointer || pointer->suffix != 0 || pointer->code < 1 || pointer->code > 14)
        return cursor.fail(place, "expected a pointer, r1 to r14");
    Memory memory{pointer->code, 0};
    if (cursor.accept("--")) return Memory{pointer->code, isa::decrement_code};
    if (!cursor.accept("++")) return memory;
    const Place step_place = cursor.peek().place;
    const auto step = cursor.accept_register();
    memory.step = step ? step->code : isa::increment_code;
    if (step && step->suffix != 0) return cursor.fail(step_place, "expected a whole register");
    return memory;
}

std::optional<unsigned> data_operand(Cursor& cursor, Access access) {
    const Token& token = cursor.peek();
    if (token.is("*")) {
        const Place place = token.place;
        const auto memory = memory_operand(cursor);
        if (!memory) return std::nullopt;
        const unsigned step = memory->step;
        unsigned index = 0;
        if (step == isa::decrement_code || step == isa::increment_code) {
            index = step - 16;
        } else if (step != 0) {
            if (step < isa::register_r15 || step > isa::register_r15 + 4)
                return cursor.fail(place, "the data unit adds r15 to r19 to a pointer");
            index = step - 16;
        }
        return (memory->pointer << 3U) | index;
    }
    if (const auto port = isa::code_of(isa::port_names, token.text)) {
        cursor.take();
        return port;
    }
    const auto number = accumulator_of(token.text);
    if (access == Access::write || !number || token.kind != TokenKind::name)
        return cursor.fail(access == Access::write
                               ? "expected memory, as *r1++, found " + shown(token)
                               : "expected an accumulator or memory, found " + shown(token));
    cursor.take();
    return number;
}

std::optional<Word> data_instruction(Cursor& cursor, isa::Dialect dialect,
                                     std::optional<unsigned> z) {
    return DataParser(cursor, dialect, z).parse();
}

}  // namespace pxm::dsp32::assembler
