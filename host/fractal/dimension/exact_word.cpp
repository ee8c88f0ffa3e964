#include "host/fractal/dimension/exact_word.hpp"

#include <cmath>
#include <glm/vec3.hpp>

namespace pxm::host {

namespace {

/// Sums and products that remember whether any of them was rounded.
class ExactArithmetic {
  public:
    [[nodiscard]] bool is_exact() const { return exact_; }

    double product(double a, double b) {
        constexpr double smallest = 0x1p-960;  // the rest of a product above it is no denormal
        const double p = a * b;
        const bool zero = a == 0 || b == 0;
        exact_ = exact_ && (zero || (std::abs(p) >= smallest && std::fma(a, b, -p) == 0));
        return p;
    }
    double sum(double a, double b) {
        const double s = a + b;
        const double of_b = s - a;  // and what is left of a and b, which double always holds
        exact_ = exact_ && (a - (s - of_b)) + (b - of_b) == 0;
        return s;
    }

  private:
    bool exact_ = true;
};

/// first, then second.
Affine then(ExactArithmetic& exact, const Affine& first, const Affine& second) {
    const auto image = [&](const glm::dvec3& x) {
        glm::dvec3 result;
        for (int r = 0; r < 3; ++r) {
            double sum = 0;
            for (int c = 0; c < 3; ++c) {
                sum = exact.sum(sum, exact.product(second.linear[c][r], x[c]));
            }
            result[r] = sum;
        }
        return result;
    };
    Affine result;
    for (int c = 0; c < 3; ++c) result.linear[c] = image(first.linear[c]);
    const glm::dvec3 moved = image(first.translation);
    for (int r = 0; r < 3; ++r) {
        result.translation[r] = exact.sum(moved[r], second.translation[r]);
    }
    return result;
}

}  // namespace

std::optional<Affine> exact_word(const Rifs& rifs, const std::vector<int>& word) {
    ExactArithmetic exact;
    Affine map = rifs.maps[word.back()];
    for (std::size_t i = word.size() - 1; i-- > 0;) map = then(exact, map, rifs.maps[word[i]]);
    if (!exact.is_exact()) return std::nullopt;
    return map;
}

bool are_exactly_one_map(const Rifs& rifs, const std::vector<int>& a, const std::vector<int>& b) {
    if (rifs.follow_of[a.back()] != rifs.follow_of[b.back()]) return false;
    const auto of_a = exact_word(rifs, a);
    return of_a && of_a == exact_word(rifs, b);
}

}  // namespace pxm::host
