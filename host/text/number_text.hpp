// Numbers as people write them, in options and in the environment: decimal digits, whatever zeros
// lead them (strtol and CLI11 2.1.2 take 010 for 8), with or without a sign. No other base, no
// blanks, no unit, and nothing is cut off.
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <optional>
#include <string_view>

namespace pxm::host {

/// The number that is all of the text; empty if it is none or does not fit. A real number may have
/// a fraction and an exponent (1e-3) and is finite.
template <class Number>
[[nodiscard]] std::optional<Number> number_of_text(std::string_view text) {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-')) return std::nullopt;
    }
    Number value{};
    const char* end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stopped != end) return std::nullopt;
    if constexpr (std::floating_point<Number>) {
        if (!std::isfinite(value)) return std::nullopt;
    }
    return value;
}

}  // namespace pxm::host
