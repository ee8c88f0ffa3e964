#include "host/import/eisenscript/eisen_color.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace pxm::host {
namespace {

constexpr double color_steps = 10'000;  // four digits of a colour are enough

EisenColor of_rgb(double r, double g, double b) {
    const double high = std::max({r, g, b});
    const double low = std::min({r, g, b});
    const double span = high - low;
    double sixth = 0;
    if (span > 0) {
        if (high == r) sixth = (g - b) / span;
        if (high == g && high != r) sixth = (b - r) / span + 2;
        if (high == b && high != r && high != g) sixth = (r - g) / span + 4;
    }
    const double hue = 60 * (sixth < 0 ? sixth + 6 : sixth);
    return {hue, high > 0 ? span / high : 0, high};
}

double hex(std::string_view text, std::size_t at, std::size_t digits) {
    int value = 0;
    for (std::size_t i = 0; i < digits; ++i) {
        const char c = text[at + i];
        value = 16 * value + (c <= '9' ? c - '0' : c - 'a' + 10);
    }
    return value / (digits == 1 ? 15.0 : 255.0);
}

double wrapped(double hue) { return hue - 360 * std::floor(hue / 360); }

double linear_of_srgb(double v) {  // IEC 61966-2-1
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

}  // namespace

std::optional<EisenColor> eisen_color(std::string_view word) {
    static const std::map<std::string, std::string, std::less<>> names{
        {"white", "#ffffff"},    {"black", "#000000"},  {"red", "#ff0000"},
        {"green", "#008000"},    {"blue", "#0000ff"},   {"yellow", "#ffff00"},
        {"cyan", "#00ffff"},     {"aqua", "#00ffff"},   {"magenta", "#ff00ff"},
        {"fuchsia", "#ff00ff"},  {"gray", "#808080"},   {"grey", "#808080"},
        {"silver", "#c0c0c0"},   {"maroon", "#800000"}, {"olive", "#808000"},
        {"lime", "#00ff00"},     {"teal", "#008080"},   {"navy", "#000080"},
        {"purple", "#800080"},   {"orange", "#ffa500"}, {"brown", "#a52a2a"},
        {"pink", "#ffc0cb"},     {"gold", "#ffd700"},   {"darkgray", "#a9a9a9"},
        {"lightgray", "#d3d3d3"}};
    if (const auto found = names.find(word); found != names.end()) word = found->second;
    const bool digits = word.find_first_not_of("0123456789abcdef", 1) == std::string_view::npos;
    if (!word.starts_with('#') || !digits || (word.size() != 4 && word.size() != 7))
        return std::nullopt;
    const std::size_t each = word.size() == 4 ? 1 : 2;
    return of_rgb(hex(word, 1, each), hex(word, 1 + each, each), hex(word, 1 + 2 * each, each));
}

EisenColor stepped(const EisenColor& color, const EisenTransform& step) {
    EisenColor next = color;
    if (step.set) {
        next = *step.set;
    }
    next.hue = wrapped(next.hue + step.change.hue);
    next.saturation = std::clamp(next.saturation * step.change.saturation, 0.0, 1.0);
    next.value = std::clamp(next.value * step.change.value, 0.0, 1.0);
    if (step.blend_strength == 0 || step.blend_strength == -1) return next;
    const double k = step.blend_strength;
    next.hue = wrapped((next.hue + k * step.blend.hue) / (1 + k));
    next.saturation = std::clamp((next.saturation + k * step.blend.saturation) / (1 + k), 0.0, 1.0);
    next.value = std::clamp((next.value + k * step.blend.value) / (1 + k), 0.0, 1.0);
    return next;
}

glm::dvec3 scene_color(const EisenColor& color) {
    const auto channel = [&](double shift) {
        const double k = std::fmod(shift + color.hue / 60, 6.0);
        const double share = std::clamp(std::min(k, 4 - k), 0.0, 1.0);
        const double srgb = color.value * (1 - color.saturation * share);
        return std::round(linear_of_srgb(srgb) * color_steps) / color_steps;
    };
    return {channel(5), channel(3), channel(1)};
}

}  // namespace pxm::host
