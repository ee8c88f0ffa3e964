#include "pxm/dsp32/assembler/assembler.hpp"

#include <algorithm>

#include "pxm/dsp32/assembler/instruction_parser.hpp"
#include "pxm/dsp32/assembler/layout.hpp"

namespace pxm::dsp32::assembler {

namespace {

/// The second pass.
class Writer {
  public:
    Writer(const Layout& layout, Mistakes& mistakes) : layout_(layout), mistakes_(mistakes) {
        bytes_.resize(static_cast<std::size_t>(layout.words()) * 4);
    }

    void write(Assembly& assembly) {
        for (const Item& item : layout_.items) {
            if (mistakes_.full()) break;
            write(item);
            const std::int64_t end = at_;
            const std::int64_t start = layout_.address_of(item.section, item.offset_bytes);
            assembly.placed.push_back({static_cast<std::uint32_t>(start),
                                       static_cast<std::uint32_t>(std::max(end, start) - start),
                                       item.line->front().place.line});
        }
        finish(assembly.object);
    }

  private:
    void write(const Item& item) {
        at_ = layout_.address_of(item.section, item.offset_bytes);
        const ValueOf value_of = [&](std::string_view name) { return value(name); };
        const std::int64_t start = at_;
        for (std::int64_t i = 0; i < item.repeats; ++i) {
            Cursor cursor(*item.line, value_of, mistakes_);
            while (&cursor.peek() != &(*item.line)[item.first_token]) cursor.take();
            if (item.kind == ItemKind::instruction) {
                instruction(cursor);
            } else {
                values(cursor, item.kind);
            }
            if (cursor.failed() || at_ == start) return;
        }
    }
    void instruction(Cursor& cursor) {
        const Surroundings around{static_cast<std::uint32_t>(at_),
                                  static_cast<std::uint32_t>(layout_.text_bytes), layout_.dialect};
        if (const auto word = instruction_word(cursor, around)) put(*word, 4);
    }
    void values(Cursor& cursor, ItemKind kind) {
        do {
            if (!value(cursor, kind)) return;
        } while (cursor.accept(","));
        cursor.expect_end();
    }
    bool value(Cursor& cursor, ItemKind kind) {
        if (kind == ItemKind::reals) {
            const auto number = cursor.real_number();
            if (number) put(word_of(*number), 4);
            return number.has_value();
        }
        const bool half = kind == ItemKind::halves;
        const auto number =
            half ? cursor.expression(-0x8000, 0xFFFF, "a number of 16 bits")
                 : cursor.expression(-0x8000'0000LL, 0xFFFF'FFFFLL, "a number of 32 bits");
        if (number) put(static_cast<Word>(*number), half ? 2 : 4);
        return number.has_value();
    }
    /// The lower half of a word lies at the lower address [S9].
    void put(Word word, int bytes) {
        for (int i = 0; i < bytes; ++i)
            bytes_[static_cast<std::size_t>(at_++)] = static_cast<std::uint8_t>(word >> (8 * i));
    }
    [[nodiscard]] std::optional<std::int64_t> value(std::string_view name) const {
        if (name == ".") return at_;
        const auto found = layout_.names.find(name);
        if (found == layout_.names.end()) return std::nullopt;
        return layout_.address_of(found->second.section, found->second.value);
    }

    void finish(Object& object) const {
        object.dialect = layout_.dialect;
        const auto data = static_cast<std::size_t>(layout_.data_address());
        for (std::size_t at = 0; at < bytes_.size(); at += 4) {
            const Word word = static_cast<Word>(bytes_[at]) | (Word{bytes_[at + 1]} << 8U) |
                              (Word{bytes_[at + 2]} << 16U) | (Word{bytes_[at + 3]} << 24U);
            (at < data ? object.text : object.data).push_back(word);
        }
        for (const auto& [name, meaning] : layout_.names) {
            if (meaning.section == Section::none) continue;
            const std::int64_t address = layout_.address_of(meaning.section, meaning.value);
            object.symbols.push_back({name, static_cast<std::uint32_t>(address)});
        }
        std::ranges::stable_sort(object.symbols, {}, &Symbol::address);
    }

    const Layout& layout_;
    Mistakes& mistakes_;
    std::int64_t at_ = 0;
    std::vector<std::uint8_t> bytes_;
};

std::string hexadecimal(std::uint32_t number, int digits) {
    static constexpr char digit[] = "0123456789abcdef";
    std::string text;
    for (int i = digits - 1; i >= 0; --i) text += digit[number >> (4 * i) & 15U];
    return text;
}

Word word_at(const Object& object, std::uint32_t address) {
    const std::size_t i = address / 4;
    if (i < object.text.size()) return object.text[i];
    return i < object.words() ? object.data[i - object.text.size()] : 0;
}

}  // namespace

Assembly assemble(std::string_view source, isa::Dialect dialect) {
    Assembly assembly;
    assembly.words_limit = fast_memory_bytes / 4;
    Mistakes mistakes;
    const std::vector<Line> lines = lines_of(source, mistakes);
    const Layout layout = layout_of(lines, dialect, mistakes);
    assembly.words = layout.words();
    // What does not fit is not made: its size is all there is to say.
    if (!assembly.too_large()) Writer(layout, mistakes).write(assembly);
    assembly.mistakes = mistakes.list();
    std::ranges::stable_sort(assembly.mistakes, {},
                             [](const Mistake& mistake) { return mistake.place.line; });
    if (!assembly.mistakes.empty()) assembly.object = {};
    return assembly;
}

std::string listing(const Assembly& assembly, std::string_view source) {
    std::string text;
    int line = 1;
    auto next = assembly.placed.begin();
    while (!source.empty()) {
        const std::size_t length = std::min(source.find('\n'), source.size());
        std::string_view shown = source.substr(0, length);
        bool first = true;
        for (; next != assembly.placed.end() && next->line == line; ++next) {
            for (std::uint32_t at = next->address; at < next->address + next->bytes;
                 at += 4 - at % 4) {
                text += hexadecimal(at, 4) + "  " + hexadecimal(word_at(assembly.object, at), 8);
                text += first && !shown.empty() ? "  " + std::string(shown) + "\n" : "\n";
                first = false;
            }
        }
        if (first) text += shown.empty() ? "\n" : std::string(16, ' ') + std::string(shown) + "\n";
        source.remove_prefix(std::min(source.size(), length + 1));
        ++line;
    }
    return text;
}

std::optional<Word> assemble_instruction(std::string_view text, std::uint32_t address,
                                         std::uint32_t program_bytes, isa::Dialect dialect) {
    Mistakes mistakes;
    const std::vector<Line> lines = lines_of(text, mistakes);
    if (lines.size() != 1 || mistakes.count() != 0) return std::nullopt;
    const ValueOf nothing = [](std::string_view) { return std::nullopt; };
    Cursor cursor(lines.front(), nothing, mistakes);
    return instruction_word(cursor, {address, program_bytes, dialect});
}

}  // namespace pxm::dsp32::assembler
