#include "host/render/render_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "host/error.hpp"
#include "host/scene/words.hpp"
#include "host/text/nearest.hpp"
#include "host/text/number_text.hpp"

namespace pxm::host {

namespace {

[[noreturn]] void refuse(const char* option, const std::string& found, const std::string& expected,
                         const std::string& hint = "") {
    throw Error(ErrorKind::setting,
                fmt::format("{}: found \"{}\", expected {}{}", option, found, expected, hint));
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

/// The whole numbers of a text, if there are exactly `count`.
std::optional<std::vector<long>> integers(const std::string& text, char separator,
                                          std::size_t count) {
    std::vector<long> values;
    for (const std::string& part : split(text, separator)) {
        const auto value = number_of_text<long>(part);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    if (values.size() != count) return std::nullopt;
    return values;
}

/// The value that one of the scene language's words stands for.
template <class Words>
auto parse_word(const char* option, const Words& words, const std::string& text) {
    if (const auto value = value_of(words, text)) return *value;
    std::vector<std::string_view> expected;
    for (const auto& word : words) expected.push_back(word.text);
    refuse(option, text, fmt::format("one of {}", fmt::join(expected, ", ")),
           suggestion(text, expected));
}

}  // namespace

PixelSize parse_size(const std::string& text) {
    const auto values = integers(text, 'x', 2);
    if (!values || std::ranges::any_of(*values, [](long v) { return v < 1 || v > 65536; })) {
        refuse("--size", text, "WxH with 1 to 65536 pixels a side, as in 640x480");
    }
    return {(*values)[0], (*values)[1]};
}

CropWindow parse_crop(const std::string& text) {
    const auto v = integers(text, ',', 4);
    if (!v || (*v)[0] < 0 || (*v)[1] < 0 || (*v)[2] <= (*v)[0] || (*v)[3] <= (*v)[1]) {
        refuse("--crop", text, "x0,y0,x1,y1 with x0 < x1 and y0 < y1 (half open)");
    }
    return {(*v)[0], (*v)[1], (*v)[2], (*v)[3]};
}

std::pair<long, long> parse_pixel(const std::string& text) {
    const auto values = integers(text, ',', 2);
    if (!values) refuse("--pixel", text, "x,y");
    return {(*values)[0], (*values)[1]};
}

CoversChoice parse_covers(const std::string& text) {
    if (text == "off") return CoversOff{};
    if (text == "on") return Covers{};
    if (text == "area") return AreaCovers{};
    const auto parts = split(text, ',');
    if (parts.size() == 2) {
        const auto low = number_of_text<double>(parts[0]);
        const auto high = number_of_text<double>(parts[1]);
        if (low && high && *low > 0 && *high > *low) return Covers{*low, *high};
    }
    refuse("--covers", text, "on, off, area, or tmin,tmax in pixels with 0 < tmin < tmax",
           suggestion(text, {"on", "off", "area"}));
}

std::vector<Aov> parse_aovs(const std::string& text) {
    std::vector<Aov> aovs;
    for (const std::string& name : split(text, ',')) {
        const auto found =
            std::ranges::find_if(all_aovs(), [&](Aov aov) { return name == aov_name(aov); });
        if (found == all_aovs().end()) {
            std::vector<std::string_view> expected;
            for (const Aov aov : all_aovs()) expected.push_back(aov_name(aov));
            refuse("--aov", name,
                   fmt::format("names out of {}, separated by commas", fmt::join(expected, " ")),
                   suggestion(name, expected));
        }
        if (std::ranges::find(aovs, *found) == aovs.end()) aovs.push_back(*found);
    }
    return aovs;
}

Numeric parse_numeric(const std::string& text) {
    return parse_word("--numeric", numeric_words, text);
}
Shading parse_shading(const std::string& text) {
    return parse_word("--shading", shading_words, text);
}
IntersectMethod parse_intersect(const std::string& text) {
    return parse_word("--intersect", intersect_words, text);
}
LipschitzMethod parse_lipschitz(const std::string& text) {
    return parse_word("--lipschitz", lipschitz_words, text);
}
VolumeKind parse_volume(const std::string& text) {
    return parse_word("--volume", volume_words, text);
}

const Model& parse_model(const char* option, const std::string& text) {
    if (const Model* model = find_model(text)) return *model;
    std::vector<std::string_view> expected;
    for (const Model& model : models()) expected.push_back(model.name);
    refuse(option, text, fmt::format("a model out of {}", fmt::join(expected, " ")),
           suggestion(text, expected));
}

}  // namespace pxm::host
