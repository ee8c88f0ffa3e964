#include "host/fractal/similarity.hpp"

#include <cmath>

#include "host/fractal/lipschitz.hpp"
#include "host/fractal/word_sums.hpp"

namespace pxm::host {

std::optional<Interval> similarity_dimension(const Rifs& rifs) {
    std::vector<double> log_ratio;
    for (const Affine& map : rifs.maps) {
        const MapKind kind = classify(map);
        if (kind != MapKind::homothety && kind != MapKind::similitude) return std::nullopt;
        log_ratio.push_back(std::log(determinant_constant(map)));
    }
    const auto components = cyclic_components(rifs);
    std::vector<double> weight(log_ratio.size());
    return critical_exponent([&](double d) {
        for (std::size_t m = 0; m < weight.size(); ++m) weight[m] = std::exp(d * log_ratio[m]);
        return growth(map_sums(rifs, weight), components);  // Eq. 5.19
    });
}

}  // namespace pxm::host
