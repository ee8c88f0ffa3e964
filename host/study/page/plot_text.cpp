#include "host/study/page/plot_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/text/printable.hpp"

namespace pxm::host {

std::string number_text(double value) {
    if (value == 0) return "0";
    if (!std::isfinite(value)) return value > 0 ? "inf" : value < 0 ? "-inf" : "nan";
    const double size = std::abs(value);
    if (size < 1e-4 || size >= 1e9) return fmt::format("{:.3g}", value);
    if (size < 1000) return fmt::format("{:.4g}", value);
    const std::string digits = fmt::format("{:.0f}", size);
    std::string grouped(value < 0 ? 1 : 0, '-');
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) grouped += ',';
        grouped += digits[i];
    }
    return grouped;
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : printable_lines(text)) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\n':
                result += "&#10;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

}  // namespace pxm::host
