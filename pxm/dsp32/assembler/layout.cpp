#include "pxm/dsp32/assembler/layout.hpp"

#include <algorithm>
#include <array>

#include "pxm/dsp32/assembler/instruction_parser.hpp"

namespace pxm::dsp32::assembler {

namespace {

struct DataDirective {
    std::string_view name;
    ItemKind kind;
    int bytes;
};
constexpr std::array<DataDirective, 3> data_directives{
    {{"float", ItemKind::reals, 4}, {"int", ItemKind::halves, 2}, {"word", ItemKind::words, 4}}};

/// A directive of values, with or without its dot.
const DataDirective* data_directive(const Token& token) {
    if (token.kind != TokenKind::name) return nullptr;
    const std::string_view name = token.text.substr(token.text.starts_with('.') ? 1 : 0);
    const auto found = std::ranges::find(data_directives, name, &DataDirective::name);
    return found == data_directives.end() ? nullptr : &*found;
}

class Layouter {
  public:
    Layouter(isa::Dialect dialect, Mistakes& mistakes) : mistakes_(mistakes) {
        layout_.dialect = dialect;
    }

    Layout run(const std::vector<Line>& lines) {
        for (const Line& line : lines) {
            if (mistakes_.full() || here() > most_bytes) break;
            place(line);
        }
        return std::move(layout_);
    }

  private:
    [[nodiscard]] std::int64_t& here() {
        return section_ == Section::text ? layout_.text_bytes : layout_.data_bytes;
    }

    void place(const Line& line) {
        std::size_t at = 0;
        while (line[at].kind == TokenKind::name && line[at + 1].is(":")) {
            define(line[at], {section_, here()});
            at += 2;
        }
        if (line[at].kind == TokenKind::end) return;
        if (line[at].is(".") || (line[at].text.starts_with('.') && !data_directive(line[at])))
            return directive(line, at);
        std::int64_t repeats = 1;
        if (line[at].kind == TokenKind::integer && line[at + 1].is("*")) {
            repeats = line[at].integer;
            at += 2;
        }
        if (const DataDirective* data = data_directive(line[at]))
            return values(line, at + 1, *data, repeats);
        if (line[at].is("#"))
            return mistakes_.add(line[at].place,
                                 "there is no preprocessor; .equ NAME, VALUE names a number");
        instruction(line, at);
    }

    void define(const Token& name, Meaning meaning) {
        const std::string text(name.text);
        if (is_reserved(name.text) || name.text.starts_with('.'))
            return mistakes_.add(name.place, quoted(text) + " has a meaning already");
        if (!layout_.names.emplace(text, meaning).second)
            mistakes_.add(name.place, quoted(text) + " is there twice");
    }

    void instruction(const Line& line, std::size_t at) {
        if (section_ == Section::data)
            return mistakes_.add(line[at].place,
                                 "instructions belong into .text; is " + shown(line[at]) + " one?");
        add({ItemKind::instruction, section_, here(), 1, &line, at}, 4, 4);
    }
    void values(const Line& line, std::size_t at, const DataDirective& data, std::int64_t repeats) {
        const auto commas = std::count_if(line.begin() + static_cast<std::ptrdiff_t>(at),
                                          line.end(), [](const Token& t) { return t.is(","); });
        if (repeats < 0 || repeats > most_bytes)
            return mistakes_.add(line[at].place, "so many are not possible");
        add({data.kind, section_, here(), repeats, &line, at}, repeats * (commas + 1) * data.bytes,
            data.bytes);
    }
    void add(const Item& item, std::int64_t bytes, int unit_bytes) {
        if (here() % unit_bytes != 0)
            return mistakes_.add((*item.line)[item.first_token].place,
                                 "this lies at no multiple of " + std::to_string(unit_bytes) +
                                     " bytes; .align 4 goes to the next");
        layout_.items.push_back(item);
        here() += bytes;
    }

    void directive(const Line& line, std::size_t at) {
        const ValueOf value_of = [&](std::string_view name) { return value(name); };
        Cursor all(line, value_of, mistakes_);
        while (&all.peek() != &line[at]) all.take();
        const Token& name = all.take();
        if (name.is(".text") || name.is(".data")) {
            section_ = name.is(".text") ? Section::text : Section::data;
        } else if (name.is(".rsect")) {
            named_section(all);
        } else if (name.is(".dsp32") || name.is(".dsp32c")) {
            layout_.dialect = name.is(".dsp32") ? isa::Dialect::dsp32 : isa::Dialect::dsp32c;
        } else if (name.is(".global")) {
            while (all.take().kind == TokenKind::name && all.accept(",")) {
            }
        } else if (name.is(".equ")) {
            equal(all);
        } else if (!move_on(all, name)) {
            all.fail(name.place, "unknown directive " + shown(name));
        }
        if (!all.failed()) all.expect_end();
    }
    void named_section(Cursor& cursor) {
        if (!cursor.expect("\"")) return;
        const Token& name = cursor.take();
        if (!name.is(".text") && !name.is(".data")) {
            cursor.fail(name.place, "there are the sections .text and .data");
        } else if (cursor.expect("\"")) {
            section_ = name.is(".text") ? Section::text : Section::data;
        }
    }
    void equal(Cursor& cursor) {
        const Token& name = cursor.take();
        if (name.kind != TokenKind::name) {
            cursor.fail(name.place, "expected a name, found " + shown(name));
        } else if (cursor.expect(",")) {
            if (const auto number = cursor.expression()) define(name, {Section::none, *number});
        }
    }
    /// .space N, .align N and . = N; false if it is none of them.
    bool move_on(Cursor& cursor, const Token& name) {
        std::optional<std::int64_t> to;
        if (name.is(".space")) {
            to = cursor.expression(0, most_bytes, "the space");
            if (to) to = here() + *to;
        } else if (name.is(".align")) {
            const auto unit = cursor.expression(1, 4096, "what to align to");
            if (unit) to = (here() + *unit - 1) / *unit * *unit;
        } else if (name.is(".")) {
            if (!cursor.expect("=")) return true;
            to = cursor.expression(here(), most_bytes, "the place, which only moves forward,");
        } else {
            return false;
        }
        if (to) here() = *to;
        return true;
    }
    /// What stands above: numbers, and labels of the text.
    [[nodiscard]] std::optional<std::int64_t> value(std::string_view name) {
        if (name == ".") return here();
        const auto found = layout_.names.find(name);
        if (found == layout_.names.end() || found->second.section == Section::data)
            return std::nullopt;
        return found->second.value;
    }

    Layout layout_;
    Mistakes& mistakes_;
    Section section_ = Section::text;
};

}  // namespace

Layout layout_of(const std::vector<Line>& lines, isa::Dialect dialect, Mistakes& mistakes) {
    return Layouter(dialect, mistakes).run(lines);
}

}  // namespace pxm::dsp32::assembler
