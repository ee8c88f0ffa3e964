#include "host/fractal/dimension/similarity.hpp"

#include <cmath>

#include "host/fractal/system/word_sums.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr double ratio_error = 1e-15;  // of a ratio, relative

}  // namespace

std::optional<Interval> similarity_dimension(const Rifs& rifs) {
    std::vector<double> log_ratio;
    for (const Affine& map : rifs.maps) {
        const MapKind kind = classify(map);
        if (kind != MapKind::homothety && kind != MapKind::similitude) return std::nullopt;
        log_ratio.push_back(std::log(determinant_constant(map)));
    }
    return exponent_of_ratios(rifs, log_ratio, ratio_error);
}

Interval exponent_of_ratios(const Rifs& rifs, const std::vector<double>& log_ratio, double error) {
    if (!branches(rifs)) return {0, 0};
    const auto components = cyclic_components(rifs);
    std::vector<double> weight(log_ratio.size());
    return critical_exponent([&](double d) {
        for (std::size_t m = 0; m < weight.size(); ++m) weight[m] = std::exp(d * log_ratio[m]);
        return growth(map_sums(rifs, weight), components, scene_error + d * error);  // Eq. 5.19
    });
}

}  // namespace pxm::host
