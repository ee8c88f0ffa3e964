#include "host/fractal/dimension/default_weights.hpp"

#include <algorithm>
#include <cmath>

#include "host/fractal/bounds/affine_hull.hpp"
#include "host/fractal/dimension/similarity.hpp"
#include "host/fractal/system/components.hpp"
#include "host/fractal/system/growth.hpp"
#include "host/fractal/system/word_sums.hpp"

namespace pxm::host {

namespace {

constexpr double floor_share = 1e-3;  // of the largest weight beside it
constexpr double work_limit = 2e7;    // entries looked at in one component
constexpr double settled = 1e-12;     // a change of a share that is none

std::vector<double> stretches(const Rifs& rifs) {
    const std::vector<AffineHull> hulls = affine_hulls(rifs);
    std::vector<double> factors;
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        const AffineHull& inside = hulls[rifs.follow_of[m]];
        factors.push_back(inside.dimension > 0 ? stretch_within(inside, rifs.maps[m])
                                               : std::abs(determinant(rifs.maps[m])));
    }
    return factors;
}

double row_times(const StepMatrix& matrix, int row, const std::vector<double>& x) {
    double sum = 0;
    for (std::size_t e = matrix.first[row]; e < matrix.first[row + 1]; ++e) {
        sum += matrix.weight[e] * x[matrix.to[e]];
    }
    return sum;
}

/// The dominant eigenvector on the sets of a component, largest entry 1. Rows are taken against
/// the order of the sets, with what was just computed, so that a wave runs along a long cycle.
void find_shares(const StepMatrix& matrix, const std::vector<int>& sets, std::vector<double>& x) {
    double work = 0;
    while (work < work_limit) {
        double image = 0;
        double sum = 0;
        for (const int s : sets) {
            image += row_times(matrix, s, x);
            sum += x[s];
            work += 2 * static_cast<double>(matrix.first[s + 1] - matrix.first[s]);
        }
        const double radius = image / sum;
        if (!(radius > 0)) return;  // flat maps alone: all shares alike
        double change = 0;
        double largest = 0;
        for (auto s = sets.rbegin(); s != sets.rend(); ++s) {
            const double old = x[*s];
            x[*s] = (old + row_times(matrix, *s, x) / radius) / 2;
            change = std::max(change, std::abs(x[*s] / old - 1));
            largest = std::max(largest, x[*s]);
        }
        for (const int s : sets) x[s] /= largest;
        if (change < settled) return;
    }
}

/// Of each follow set: what may stand there, against the other sets of its component. Sets that no
/// cycle passes are made of what they lead to.
std::vector<double> shares(const Rifs& rifs, const std::vector<double>& factors) {
    std::vector<double> x(rifs.follow_sets.size(), 1);
    std::vector<char> cyclic(x.size(), 0);
    const StepMatrix matrix = map_sums(rifs, factors);
    for (const std::vector<int>& component : cyclic_components(rifs)) {
        find_shares(matrix, component, x);
        for (const int s : component) cyclic[s] = 1;
    }
    std::vector<int> order(x.size());  // what a set leads to comes before it
    for (std::size_t s = 0; s < order.size(); ++s) order[s] = static_cast<int>(s);
    const std::vector<int> component = set_components(rifs);
    std::ranges::sort(order, std::greater<>{}, [&](int s) { return component[s]; });
    for (const int s : order) {
        if (cyclic[s]) continue;
        x[s] = 0;
        for (const int m : rifs.follow_sets[s].maps) x[s] += factors[m] * x[rifs.follow_of[m]];
    }
    return x;
}

/// What is stretched by `weights`, of what has its share; at least a thousandth of the largest.
std::vector<double> with_shares(const Rifs& rifs, std::vector<double> weights) {
    const std::vector<double> share = shares(rifs, weights);
    for (std::size_t m = 0; m < weights.size(); ++m) weights[m] *= share[rifs.follow_of[m]];
    std::vector<double> least(weights.size(), 0);
    for (const FollowSet& set : rifs.follow_sets) {
        double largest = 0;
        for (const int m : set.maps) largest = std::max(largest, weights[m]);
        const double floor = largest > 0 ? floor_share * largest : 1;
        for (const int m : set.maps) least[m] = std::max(least[m], floor);
    }
    for (std::size_t m = 0; m < weights.size(); ++m) {
        weights[m] = std::max(weights[m], least[m]);
    }
    return weights;
}

}  // namespace

std::vector<double> default_weights(const Rifs& rifs) { return with_shares(rifs, stretches(rifs)); }

std::vector<double> natural_weights(const Rifs& rifs) {
    std::vector<double> weights = stretches(rifs);
    std::vector<double> logarithms;
    for (const double weight : weights) logarithms.push_back(std::log(weight));
    const double power = exponent_of_ratios(rifs, logarithms, 0).middle();
    if (!(power > 0) || !std::isfinite(power)) return default_weights(rifs);
    for (double& weight : weights) weight = std::pow(weight, power);
    return with_shares(rifs, weights);
}

}  // namespace pxm::host
