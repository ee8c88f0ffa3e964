// Pearson's test of goodness of fit.
#pragma once

#include <cmath>
#include <vector>

namespace pxm::test {

/// The value that chi-square with so many degrees of freedom exceeds with probability 1e-5
/// [Wilson and Hilferty's approximation, good to a few in a thousand here].
[[nodiscard]] inline double chi_square_limit(double degrees) {
    constexpr double normal_quantile = 4.26489;  // of 1 - 1e-5
    const double spread = 2 / (9 * degrees);
    return degrees * std::pow(1 - spread + normal_quantile * std::sqrt(spread), 3);
}

struct ChiSquare {
    double value = 0;
    double degrees = -1;
    [[nodiscard]] bool fits() const { return degrees < 1 || value < chi_square_limit(degrees); }
};

/// Counts against probabilities; outcomes that are expected less than five times count as one.
[[nodiscard]] inline ChiSquare chi_square(const std::vector<double>& counts,
                                          const std::vector<double>& probabilities, double total) {
    ChiSquare result;
    double rare = 0;
    double rare_expected = 0;
    const auto add = [&](double count, double expected) {
        result.value += (count - expected) * (count - expected) / expected;
        ++result.degrees;
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double expected = probabilities[i] * total;
        if (expected < 5) {
            rare += counts[i];
            rare_expected += expected;
        } else {
            add(counts[i], expected);
        }
    }
    if (rare_expected > 0) add(rare, rare_expected);
    return result;
}

}  // namespace pxm::test
