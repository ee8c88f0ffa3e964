#include "host/commands/option_checks.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>

#include "host/text/number_text.hpp"

namespace pxm::host {

namespace {

/// Puts the number's canonical text in place of what was written, or names what was found. `range`
/// stands in the help.
template <class Number, class Allowed>
OptionCheck number_check(const std::string& range, const std::string& expected, Allowed allowed) {
    const auto check = [=](std::string& text) -> std::string {
        const auto value = number_of_text<Number>(text);
        if (!value || !allowed(*value))
            return fmt::format("found \"{}\", expected {}", text, expected);
        text = fmt::format("{}", *value);
        return {};
    };
    return {check, range};
}

}  // namespace

OptionCheck whole_number(std::uint64_t low, std::uint64_t high) {
    return number_check<std::uint64_t>(
        fmt::format("{} to {}", low, high), fmt::format("a whole number from {} to {}", low, high),
        [=](std::uint64_t value) { return low <= value && value <= high; });
}

OptionCheck any_whole_number() {
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    return {whole_number(0, most).look, ""};
}

OptionCheck positive_number() {
    return number_check<double>("above 0", "a number above 0", [](double x) { return x > 0; });
}

OptionCheck share() { return number_within(0, 1); }

OptionCheck number_within(double low, double high) {
    return number_check<double>(fmt::format("{} to {}", low, high),
                                fmt::format("a number from {} to {}", low, high),
                                [=](double x) { return low <= x && x <= high; });
}

OptionCheck some_text() {
    const auto check = [](std::string& text) -> std::string {
        return text.empty() ? "found \"\", expected a value" : "";
    };
    return {check, ""};
}

}  // namespace pxm::host
