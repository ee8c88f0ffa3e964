#include "pxm/dsp32/assembler/object.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "pxm/dsp32/assembler/assembler.hpp"
#include "pxm/dsp32/isa/disassemble.hpp"

namespace pxm::dsp32::assembler {

namespace {

constexpr std::string_view head_dsp32 = "pxm-object 1 dsp32";
constexpr std::string_view head_dsp32c = "pxm-object 1 dsp32c";

std::string hexadecimal(std::uint32_t number, std::size_t digits) {
    std::array<char, 8> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, 16).ptr;
    std::string result(text.data(), end);
    return std::string(digits - std::min(digits, result.size()), '0') + result;
}

std::optional<std::uint32_t> number_of(std::string_view text, int base) {
    std::uint32_t number = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number, base);
    if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
    return number;
}

/// Takes the first line off a text.
std::string_view take_line(std::string_view& text) {
    const std::size_t length = text.find('\n');
    const std::string_view line = text.substr(0, length);
    text.remove_prefix(
        std::min(text.size(), length == std::string_view::npos ? length : length + 1));
    return line;
}

void write_words(std::string& text, std::string_view section, const std::vector<Word>& words) {
    text += std::string(section) + " " + std::to_string(words.size()) + "\n";
    for (const Word word : words) text += hexadecimal(word, 8) + "\n";
}

bool read_words(std::string_view& text, std::string_view section, std::vector<Word>& words) {
    const std::string_view line = take_line(text);
    if (!line.starts_with(section) || line.size() <= section.size() + 1) return false;
    const auto count = number_of(line.substr(section.size() + 1), 10);
    if (!count) return false;
    for (std::uint32_t i = 0; i < *count; ++i) {
        const auto word = number_of(take_line(text), 16);
        if (!word) return false;
        words.push_back(*word);
    }
    return true;
}

}  // namespace

std::optional<std::uint32_t> Object::address_of(std::string_view name) const {
    const auto found = std::ranges::find(symbols, name, &Symbol::name);
    if (found == symbols.end()) return std::nullopt;
    return found->address;
}

std::string Object::name_of(std::uint32_t address) const {
    const auto found = std::ranges::lower_bound(symbols, address, {}, &Symbol::address);
    return found == symbols.end() || found->address != address ? "" : found->name;
}

std::string text_of(const Object& object) {
    std::string text(object.dialect == isa::Dialect::dsp32 ? head_dsp32 : head_dsp32c);
    text += "\n";
    write_words(text, "text", object.text);
    write_words(text, "data", object.data);
    for (const Symbol& symbol : object.symbols)
        text += "symbol " + hexadecimal(symbol.address, 4) + " " + symbol.name + "\n";
    return text;
}

std::optional<Object> object_of(std::string_view text) {
    Object object;
    const std::string_view head = take_line(text);
    if (head != head_dsp32 && head != head_dsp32c) return std::nullopt;
    if (head == head_dsp32c) object.dialect = isa::Dialect::dsp32c;
    if (!read_words(text, "text", object.text) || !read_words(text, "data", object.data))
        return std::nullopt;
    constexpr std::string_view symbol = "symbol ";
    while (!text.empty()) {
        std::string_view line = take_line(text);
        if (!line.starts_with(symbol)) return std::nullopt;
        line.remove_prefix(symbol.size());
        const std::size_t space = line.find(' ');
        const auto address = number_of(line.substr(0, space), 16);
        if (space == std::string_view::npos || !address) return std::nullopt;
        object.symbols.push_back({std::string(line.substr(space + 1)), *address});
    }
    if (!std::ranges::is_sorted(object.symbols, {}, &Symbol::address)) return std::nullopt;
    return object;
}

std::string disassembly(const Object& object) {
    std::string text;
    std::uint32_t address = 0;
    const auto label_of = [&](std::uint32_t to) { return object.name_of(to); };
    const auto put = [&](const std::string& statement) {
        for (const Symbol& symbol : object.symbols)
            if (symbol.address == address) text += symbol.name + ":\n";
        text += "        " + statement + "\n";
        address += 4;
    };
    if (object.dialect == isa::Dialect::dsp32c) text += "        .dsp32c\n";
    for (const Word word : object.text) {
        // A number may happen to look like an instruction; only what comes back is shown as one.
        const std::string plain =
            isa::text_of(word, address, object.dialect, [](std::uint32_t) { return ""; });
        const bool comes_back =
            assemble_instruction(plain, address, static_cast<std::uint32_t>(object.text.size()) * 4,
                                 object.dialect) == word;
        put(comes_back ? isa::text_of(word, address, object.dialect, label_of)
                       : ".word 0x" + hexadecimal(word, 8));
    }
    if (!object.data.empty()) text += "        .data\n";
    for (const Word word : object.data) put(".word 0x" + hexadecimal(word, 8));
    return text;
}

}  // namespace pxm::dsp32::assembler
