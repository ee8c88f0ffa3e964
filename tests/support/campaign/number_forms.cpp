#include "tests/support/campaign/number_forms.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pxm::test {

namespace {

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ",") + part;
    return text;
}

}  // namespace

std::string NumberForms::whole(long value) {
    switch (draw_.below(4)) {
        case 0:
            return fmt::format("{} + {}", value - 1, 1);
        case 1:
            return fmt::format("{} * 3 / 3", value);
        default:
            return fmt::format("{}", value);
    }
}

std::string NumberForms::list(const std::vector<double>& values) {
    std::vector<std::string> parts;
    for (const double value : values) parts.push_back(number(value));
    if (!names_.animated || values.size() < 2 || !draw_.one_in(4)) return joined(parts);
    return keys(fmt::format("({})", joined(parts)), false);
}

/// Keys that rest at a value for all of the time.
std::string NumberForms::keys(const std::string& value, bool positive) {
    static constexpr const char* words[] = {"", ", smooth", ", linear", ", stepped",
                                            ", exponential"};
    const std::string word = words[draw_.below(positive ? 5 : 4)];
    return fmt::format("key({}: 0 -> {}, {} -> {}{})", draw_.one_in(2) ? "t" : "2 * t", value,
                       draw_.one_in(2) ? "1" : "0.5 + 1", value, word);
}

/// The form nests `depth` times at most.
std::string NumberForms::expression(double value, int depth) {
    const std::string digits =
        draw_.one_in(8) ? fmt::format("{:.17e}", value) : fmt::format("{:.6g}", value);
    if (depth == 0 || draw_.one_in(2)) return digits;
    const double other = draw_.between(0.5, 3);
    const auto inner = [&](double v) { return expression(v, depth - 1); };
    switch (draw_.below(12)) {
        case 0:
            return fmt::format("({} + {})", inner(value - other), inner(other));
        case 1:
            return fmt::format("({} - {})", inner(value + other), inner(other));
        case 2:
            return fmt::format("{} * ({})", inner(value / other), inner(other));
        case 3:
            return fmt::format("({}) / ({})", inner(value * other), inner(other));
        case 4:
            return fmt::format("-({})", inner(-value));
        case 5:
            return fmt::format("{} * sqrt({})", inner(value / other), inner(other * other));
        case 6:
            return fmt::format("{} * sin(90)", inner(value));
        case 7:
            return fmt::format("{} / cos({})", inner(value / 2), inner(60));
        case 8:
            return fmt::format("{} * tan(45)", inner(value));
        case 9:
            return draw_.one_in(2) ? fmt::format("{} * pi / pi", inner(value))
                                   : fmt::format("{} / phi * phi", inner(value));
        case 10:
            if (!names_.lets.empty()) {
                const auto& [name, known] = names_.lets[static_cast<std::size_t>(
                    draw_.below(static_cast<int>(names_.lets.size())))];
                return fmt::format("({} + {})", name, inner(value - known));
            }
            break;
        default:
            if (!names_.animated) break;
            if (draw_.one_in(2)) return fmt::format("({} + frame - t)", inner(value));
            return keys(digits, value > 0);
    }
    return fmt::format("({})", inner(value));
}

const std::vector<std::string>& NumberForms::all_signs() {
    static const std::vector<std::string> signs{
        "+",         "-(",        "*",          "/",
        "sqrt(",     "sin(",      "cos(",       "tan(",
        " pi",       " phi",      "key(t:",     "key(2 * t:",
        ", smooth)", ", linear)", ", stepped)", ", exponential)",
        "frame",     "let ",      "-> ("};
    return signs;
}

}  // namespace pxm::test
