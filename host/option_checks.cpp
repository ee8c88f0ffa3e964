#include "host/option_checks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pxm::host {

namespace {

/// A message that names what was found unless `allowed` takes the number.
template <class Allowed>
CLI::Validator number_check(const char* expected, Allowed allowed) {
    const auto check = [=](std::string& text) -> std::string {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && allowed(value)) return {};
        return fmt::format("found \"{}\", expected {}", text, expected);
    };
    return {check, "", ""};
}

}  // namespace

CLI::Validator positive_number() {
    return number_check("a number above 0", [](double x) { return x > 0 && std::isfinite(x); });
}

CLI::Validator share() {
    return number_check("a number from 0 to 1", [](double x) { return x >= 0 && x <= 1; });
}

CLI::Validator some_text() {
    const auto check = [](std::string& text) -> std::string {
        return text.empty() ? "found \"\", expected a value" : "";
    };
    return {check, "", ""};
}

}  // namespace pxm::host
