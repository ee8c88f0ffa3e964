#include "host/scene/printable.hpp"

#include <cstdint>

namespace pxm::host {
namespace {

/// Control characters (C0, DEL, C1) and the marks that change the direction of text.
bool is_hidden(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x200e && code <= 0x200f) ||
           (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) ||
           code == 0xfeff || (code >= 0xd800 && code < 0xe000) || code > 0x10ffff;
}

std::size_t sequence_length(unsigned char lead) {
    if (lead < 0x80) return 1;
    if (lead >= 0xc2 && lead < 0xe0) return 2;
    if (lead >= 0xe0 && lead < 0xf0) return 3;
    if (lead >= 0xf0 && lead < 0xf5) return 4;
    return 0;
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
        const std::size_t length = printable_length(text, at);
        if (length == 0) {
            shown += '?';
            at += 1;
        } else {
            shown += text.substr(at, length);
            at += length;
        }
    }
    return shown;
}

}  // namespace pxm::host
