#include "host/fractal/dimension/layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <map>

namespace pxm::host {

namespace {

constexpr double same = 1e-9;       // of the size: numbers nearer are one
constexpr double largest_sum = 64;  // exponents tried

double ratio(const Affine& map, int axis) { return std::abs(map.linear[axis][axis]); }

bool is_diagonal(const Affine& map) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (i != j && map.linear[i][j] != 0) return false;
    return true;
}

/// Axes in an order in which no map's ratios rise; nothing if there is none.
std::optional<std::vector<int>> order_of(const Rifs& rifs, const glm::dvec3& extent, double size) {
    std::vector<int> axes;
    for (int axis = 0; axis < 3; ++axis)
        if (extent[axis] > same * size) axes.push_back(axis);
    const auto total = [&](int axis) {
        double sum = 0;
        for (const Affine& map : rifs.maps) sum += ratio(map, axis);
        return sum;
    };
    std::ranges::sort(axes, [&](int a, int b) { return total(a) > total(b); });
    bool differ = false;
    for (const Affine& map : rifs.maps)
        for (std::size_t i = 1; i < axes.size(); ++i) {
            const double longer = ratio(map, axes[i - 1]), shorter = ratio(map, axes[i]);
            if (!(shorter <= longer * (1 + same)) || shorter == 0) return std::nullopt;
            differ = differ || shorter < longer * (1 - same);
        }
    if (!differ) return std::nullopt;
    return axes;
}

/// Per map: the number of its image along the first `count` axes.
std::vector<std::size_t> groups(const Rifs& rifs, const std::vector<int>& axes, std::size_t count,
                                double size) {
    std::map<std::vector<double>, std::size_t> known;
    std::vector<std::size_t> group;
    for (const Affine& map : rifs.maps) {
        std::vector<double> image;
        for (std::size_t i = 0; i < count; ++i) {
            image.push_back(std::round(map.linear[axes[i]][axes[i]] / same));
            image.push_back(std::round(map.translation[axes[i]] / (same * size)));
        }
        group.push_back(known.emplace(std::move(image), known.size()).first->second);
    }
    return group;
}

}  // namespace

std::optional<Layers> layers_of(const Rifs& rifs, const std::vector<Bounds>& bounds) {
    if (rifs.follow_sets.size() != 1 || !std::ranges::all_of(rifs.maps, is_diagonal))
        return std::nullopt;
    const glm::dvec3 extent = bounds[0].box.high - bounds[0].box.low;
    const double size = std::max({extent.x, extent.y, extent.z});
    const auto axes = order_of(rifs, extent, size);
    if (!axes) return std::nullopt;
    Layers layers;
    layers.axes = *axes;
    std::vector<double> share(rifs.maps.size(), 1);  // of a map's image along the axes so far
    std::vector<std::vector<std::size_t>> group_of;
    for (std::size_t level = 0; level < axes->size(); ++level) {
        group_of.push_back(groups(rifs, *axes, level + 1, size));
        const auto& group = group_of.back();
        const auto shares = [&](double exponent) {
            std::vector<double> of_groups(rifs.maps.size(), 0);
            for (std::size_t m = 0; m < group.size(); ++m)
                of_groups[group[m]] =
                    share[m] * std::pow(ratio(rifs.maps[m], (*axes)[level]), exponent);
            return of_groups;
        };
        double low = 0, high = largest_sum;
        for (int round = 0; round < 60; ++round) {
            const double middle = (low + high) / 2;
            double sum = 0;
            for (const double s : shares(middle)) sum += s;
            (sum > 1 ? low : high) = middle;
        }
        const std::vector<double> of_groups = shares(low);
        for (std::size_t m = 0; m < group.size(); ++m) share[m] = of_groups[group[m]];
        layers.choice.push_back(share);
    }
    // Within a group as all axes have it.
    for (std::size_t level = 0; level < axes->size(); ++level) {
        const auto& group = group_of[level];
        std::vector<double> sum(group.size(), 0);
        for (std::size_t m = 0; m < group.size(); ++m) sum[group[m]] += share[m];
        double total = 0;
        for (std::size_t m = 0; m < group.size(); ++m) {
            layers.choice[level][m] *= share[m] / sum[group[m]];
            total += layers.choice[level][m];
        }
        for (double& p : layers.choice[level]) p /= total;
    }
    return layers;
}

}  // namespace pxm::host
