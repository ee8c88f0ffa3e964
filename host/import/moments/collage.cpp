#include "host/import/moments/collage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pxm::host {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Squared distances along one line: min over j of (i - j)^2 + f[j], as the lower envelope of
/// parabolas; linear time.
void transform(std::vector<double>& f) {
    std::vector<std::size_t> roots;
    std::vector<double> from;  // roots[k] is lowest from from[k] on
    const auto crossing = [&](std::size_t p, std::size_t q) {
        const auto x = static_cast<double>(p);
        const auto y = static_cast<double>(q);
        return (f[q] + y * y - f[p] - x * x) / (2 * (y - x));
    };
    for (std::size_t q = 0; q < f.size(); ++q) {
        if (f[q] == infinite) continue;
        while (!roots.empty() && crossing(roots.back(), q) <= from.back()) {
            roots.pop_back();
            from.pop_back();
        }
        from.push_back(roots.empty() ? -infinite : crossing(roots.back(), q));
        roots.push_back(q);
    }
    if (roots.empty()) return;
    const std::vector<double> heights = f;
    for (std::size_t q = 0, k = 0; q < f.size(); ++q) {
        const auto x = static_cast<double>(q);
        while (k + 1 < roots.size() && from[k + 1] < x) ++k;
        const double step = x - static_cast<double>(roots[k]);
        f[q] = step * step + heights[roots[k]];
    }
}

}  // namespace

GridSet::GridSet(std::span<const WeightedPoint> points, int cells, double finest) {
    double low_x = infinite, low_y = infinite, high_x = -infinite, high_y = -infinite;
    for (const WeightedPoint& p : points) {
        low_x = std::min(low_x, p.x);
        low_y = std::min(low_y, p.y);
        high_x = std::max(high_x, p.x);
        high_y = std::max(high_y, p.y);
    }
    const double side = std::max(high_x - low_x, high_y - low_y);
    cell_ = std::max(side / cells, finest);
    if (!(cell_ > 0)) cell_ = 1;
    const double border =
        std::ceil(side / cell_ / 4) + 1;  // cells around, for images that stick out
    low_x_ = low_x - (border + 0.5) * cell_;
    low_y_ = low_y - (border + 0.5) * cell_;
    const auto count = [&](double low, double high) {
        return static_cast<std::size_t>(std::ceil((high - low) / cell_ + 2 * border + 1));
    };
    columns_ = count(low_x, high_x);
    rows_ = count(low_y, high_y);
    std::vector<char> marked(columns_ * rows_, 0);
    for (const WeightedPoint& p : points) marked[cell_of(p.x, p.y)] = 1;
    for (std::size_t c = 0; c < marked.size(); ++c)
        if (marked[c]) set_.push_back(c);
    distance_ = distances(marked);
}

std::size_t GridSet::cell_of(double x, double y) const {
    const auto along = [&](double value, double low, std::size_t count) {
        const double place = std::floor((value - low) / cell_);
        return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(count - 1)));
    };
    return along(y, low_y_, rows_) * columns_ + along(x, low_x_, columns_);
}

WeightedPoint GridSet::center(std::size_t cell) const {
    return {low_x_ + (static_cast<double>(cell % columns_) + 0.5) * cell_,
            low_y_ + (static_cast<double>(cell / columns_) + 0.5) * cell_, 1};
}

double GridSet::from_center(double x, double y) const {
    const WeightedPoint c = center(cell_of(x, y));
    return std::hypot(x - c.x, y - c.y);
}

std::vector<double> GridSet::distances(const std::vector<char>& marked) const {
    std::vector<double> squares(marked.size());
    std::vector<double> line(rows_);
    for (std::size_t x = 0; x < columns_; ++x) {
        for (std::size_t y = 0; y < rows_; ++y) line[y] = marked[y * columns_ + x] ? 0 : infinite;
        transform(line);
        for (std::size_t y = 0; y < rows_; ++y) squares[y * columns_ + x] = line[y];
    }
    line.resize(columns_);
    for (std::size_t y = 0; y < rows_; ++y) {
        const auto row = squares.begin() + static_cast<std::ptrdiff_t>(y * columns_);
        std::copy_n(row, columns_, line.begin());
        transform(line);
        std::ranges::transform(line, row, [&](double s) { return cell_ * std::sqrt(s); });
    }
    return squares;
}

double GridSet::collage_distance(std::span<const PlaneMap> maps) const {
    std::vector<char> marked(columns_ * rows_, 0);
    double farthest = 0;        // of an image from the set
    double worst_rounding = 0;  // of an image from its cell's centre
    for (const std::size_t cell : set_) {
        const WeightedPoint p = center(cell);
        for (const PlaneMap& m : maps) {
            const double x = m.a * p.x + m.b * p.y + m.e;
            const double y = m.c * p.x + m.d * p.y + m.f;
            const std::size_t at = cell_of(x, y);
            const double rounding = from_center(x, y);
            marked[at] = 1;
            farthest = std::max(farthest, distance_[at] + rounding);
            worst_rounding = std::max(worst_rounding, rounding);
        }
    }
    const std::vector<double> from_images = distances(marked);
    double uncovered = 0;
    for (const std::size_t cell : set_) uncovered = std::max(uncovered, from_images[cell]);
    return std::max(farthest, uncovered + worst_rounding);
}

double collage_bound(double collage_distance, std::span<const PlaneMap> maps) {
    double s = 0;
    for (const PlaneMap& map : maps) s = std::max(s, map.lipschitz());
    return s < 1 ? collage_distance / (1 - s) : infinite;
}

}  // namespace pxm::host
