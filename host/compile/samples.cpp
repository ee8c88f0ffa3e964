#include "host/compile/samples.hpp"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numeric>

namespace pxm::host {

namespace {

/// The bits of n mirrored at the binary point: 1, 10, 11 become 0.1, 0.01, 0.11.
double radical_inverse(std::uint64_t n) {
    double value = 0;
    for (double digit = 0.5; n != 0; n >>= 1, digit /= 2) {
        if ((n & 1) != 0) value += digit;
    }
    return value;
}

}  // namespace

std::vector<glm::dvec2> sample_places(long count) {
    const auto n = static_cast<std::size_t>(count);
    std::vector<std::size_t> by_row(n);
    std::iota(by_row.begin(), by_row.end(), 0);
    std::ranges::sort(by_row, {}, [](std::size_t i) { return radical_inverse(i); });
    std::vector<glm::dvec2> places(n);
    for (std::size_t row = 0; row < n; ++row) {
        const std::size_t column = by_row[row];
        places[column] = (glm::dvec2{static_cast<double>(column), static_cast<double>(row)} + 0.5) /
                         static_cast<double>(n);
    }
    const auto from_center = [](const glm::dvec2& place) {
        return glm::distance(place, glm::dvec2{0.5, 0.5});
    };
    std::swap(places.front(), *std::ranges::min_element(places, {}, from_center));
    return places;
}

void leave_faces(std::vector<glm::dvec2>& places) {
    // Much for floats of 32 bits in a picture of thousands of columns, and nothing to the eye.
    constexpr double share = 1.0 / 64;
    const glm::dvec2 askew{share, share * 0.6180339887498949};  // 1 / phi
    for (glm::dvec2& place : places) place += askew;
}

}  // namespace pxm::host
