#include "host/import/flame/flame_palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "host/import/fractint/fractint_reader.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t most_colors = 256;
constexpr double full = 255;  // of a byte

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const char small = lower(c);
    return small >= 'a' && small <= 'f' ? small - 'a' + 10 : -1;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// Colours of `bytes` bytes each, of which those from `first` are red, green and blue.
void read_hex(const XmlElement& element, std::string_view text, std::size_t bytes,
              std::size_t first, std::vector<PaletteColor>& palette, Diagnostics& diagnostics) {
    std::vector<int> digits;
    for (const char c : text) {
        if (is_blank(c)) continue;
        digits.push_back(hex_digit(c));
        if (digits.back() >= 0) continue;
        return diagnostics.error(element.position,
                                 fmt::format("palette: expected hexadecimal digits, found '{}'",
                                             printable(std::string(1, c))));
    }
    if (digits.empty() || digits.size() % (2 * bytes) != 0 ||
        digits.size() / (2 * bytes) > most_colors)
        return diagnostics.error(
            element.position, fmt::format("palette: expected up to {} colours of {} digits, found "
                                          "{} digits",
                                          most_colors, 2 * bytes, digits.size()));
    for (std::size_t i = 0; i < digits.size(); i += 2 * bytes) {
        PaletteColor color;
        for (std::size_t k = 0; k < color.size(); ++k) {
            const std::size_t at = i + 2 * (first + k);
            color[k] = (16 * digits[at] + digits[at + 1]) / full;
        }
        palette.push_back(color);
    }
}

/// <color index="0" rgb="255 0 0"/>, three numbers or four.
bool read_color(const XmlElement& element, std::map<std::size_t, PaletteColor>& colors) {
    const std::string* place = element.attribute("index");
    const std::string* text = element.attribute("rgb");
    if (text == nullptr) text = element.attribute("rgba");
    double index = 0;
    if (place == nullptr || text == nullptr || !read_number(*place, index)) return false;
    index = std::floor(index);
    if (!(index >= 0 && index < static_cast<double>(most_colors))) return false;
    PaletteColor color;
    std::string_view rest = *text;
    for (double& channel : color) {
        while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (!read_number(rest.substr(0, end), channel)) return false;
        channel = std::clamp(channel / full, 0.0, 1.0);
        rest.remove_prefix(end);
    }
    colors[static_cast<std::size_t>(index)] = color;
    return true;
}

/// Every place from the nearest that are there; the palette is a ring.
std::vector<PaletteColor> between(const std::map<std::size_t, PaletteColor>& colors) {
    std::vector<PaletteColor> palette;
    for (std::size_t i = 0; i < most_colors && !colors.empty(); ++i) {
        auto right = colors.lower_bound(i);
        const bool past = right == colors.end();
        auto left = right == colors.begin() ? std::prev(colors.end()) : std::prev(right);
        if (past) right = colors.begin();
        if (right->first == i) left = right;
        const std::size_t gap = (right->first + most_colors - left->first) % most_colors;
        const std::size_t way = (i + most_colors - left->first) % most_colors;
        const double share = gap == 0 ? 0 : static_cast<double>(way) / static_cast<double>(gap);
        PaletteColor color;
        for (std::size_t k = 0; k < color.size(); ++k)
            color[k] = left->second[k] + share * (right->second[k] - left->second[k]);
        palette.push_back(color);
    }
    return palette;
}

/// IEC 61966-2-1.
double linear_of_srgb(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

}  // namespace

std::vector<PaletteColor> palette_of(const XmlElement& flame, Diagnostics& diagnostics) {
    std::vector<PaletteColor> palette;
    std::map<std::size_t, PaletteColor> single;
    bool told = false;
    for (const XmlElement& child : flame.children) {
        if (child.name == "palette" && child.attribute("index0") == nullptr) {
            const std::string* format = child.attribute("format");
            palette.clear();
            read_hex(child, child.text, format != nullptr && *format == "RGBA" ? 4 : 3, 0, palette,
                     diagnostics);
        }
        if (child.name == "colors" && child.attribute("data") != nullptr) {
            palette.clear();
            read_hex(child, *child.attribute("data"), 4, 1, palette, diagnostics);
        }
        if (child.name == "color" && !read_color(child, single) && !told) {
            told = true;
            diagnostics.error(child.position,
                              "color: expected index=\"0 ... 255\" and rgb=\"r g b\"");
        }
    }
    return palette.empty() ? between(single) : palette;
}

PaletteColor palette_color(const std::vector<PaletteColor>& palette, double place) {
    const auto size = static_cast<double>(palette.size());
    const double index = std::min(std::floor(place * size), size - 1);
    PaletteColor color = palette[static_cast<std::size_t>(index)];
    for (double& channel : color) channel = linear_of_srgb(channel);
    return color;
}

}  // namespace pxm::host
