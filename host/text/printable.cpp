#include "host/text/printable.hpp"

#include <algorithm>
#include <climits>
#include <cstdint>

namespace pxm::host {
namespace {

struct CodeRange {
    std::uint32_t first, last;
};

/// Code points that change a terminal, a line or the direction of text, and what is none.
constexpr CodeRange hidden_codes[] = {
    {0x0000, 0x001f},    // C0
    {0x007f, 0x009f},    // DEL and C1
    {0x061c, 0x061c},    // the Arabic letter mark
    {0x200e, 0x200f},    // marks of direction
    {0x2028, 0x202e},    // ends of lines and paragraphs, embeddings and overrides
    {0x2060, 0x206f},    // the word joiner, invisible operators, isolates
    {0xd800, 0xdfff},    // halves of UTF-16
    {0xfeff, 0xfeff},    // the byte order mark
    {0xfff9, 0xfffb},    // annotations
    {0xe0000, 0xe007f},  // tags
    {0x110000, 0xffffffff},
};

bool is_hidden(std::uint32_t code) {
    return std::ranges::any_of(hidden_codes, [code](const CodeRange& range) {
        return range.first <= code && code <= range.last;
    });
}

std::size_t sequence_length(unsigned char lead) {
    if (lead < 0x80) return 1;
    if (lead >= 0xc2 && lead < 0xe0) return 2;
    if (lead >= 0xe0 && lead < 0xf0) return 3;
    if (lead >= 0xf0 && lead < 0xf5) return 4;
    return 0;
}

/// Adds the character at text[at], or '?' for a byte that cannot be shown; the bytes it took.
std::size_t append_shown(std::string& shown, std::string_view text, std::size_t at) {
    const std::size_t length = printable_length(text, at);
    if (length == 0) {
        shown += '?';
        return 1;
    }
    shown += text.substr(at, length);
    return length;
}

}  // namespace

std::size_t printable_length(std::string_view text, std::size_t at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t length = sequence_length(lead);
    if (length == 0 || at + length > text.size()) return 0;
    if (length == 1) return is_hidden(lead) ? 0 : 1;
    std::uint32_t code = lead & (0x7fU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const auto byte = static_cast<unsigned char>(text[at + i]);
        if ((byte & 0xc0U) != 0x80U) return 0;
        code = code << 6U | (byte & 0x3fU);
    }
    // An overlong form is no character of its own.
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    return overlong || is_hidden(code) ? 0 : length;
}

std::string printable(std::string_view text, std::size_t limit) {
    std::string shown;
    for (std::size_t at = 0; at < text.size();) {
        if (at >= limit) return shown + "...";
        at += append_shown(shown, text, at);
    }
    return shown;
}

std::string printable_lines(std::string_view text) {
    std::string shown;
    shown.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '\n' || text[at] == '\t') {
            shown += text[at++];
        } else {
            at += append_shown(shown, text, at);
        }
    }
    return shown;
}

std::string printable_path(std::string_view path) { return printable(path, PATH_MAX); }

}  // namespace pxm::host
