#include "host/text/six_digits.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pxm::host {

std::string six_digits_above(double x) {
    if (!(x > 0) || !std::isfinite(x)) return fmt::format("{:.6g}", x);
    constexpr double rounding = 1e-13;
    const double unit = std::pow(10, std::floor(std::log10(x)) - 5);
    return fmt::format("{:.6g}", std::ceil(x / unit * (1 - rounding)) * unit);
}

}  // namespace pxm::host
