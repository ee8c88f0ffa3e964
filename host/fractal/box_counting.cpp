#include "host/fractal/box_counting.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "host/fractal/inner_points.hpp"
#include "host/fractal/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr long leaf_limit = 170'000;   // cells that give a point
constexpr long visit_limit = 600'000;  // cells looked at
constexpr long random_points = 300'000;
constexpr double step = std::numbers::sqrt2;  // from one scale to the next
constexpr double cells_a_side = 2;            // boxes are at least so many cells wide
constexpr double largest_side = 0.25;         // of the attractor's size
constexpr std::size_t fewest_scales = 4;
constexpr double coarsest_cell = 1.0 / 16;  // of the size: coarser cells leave no scales
constexpr double finest_cell = 1e-6;

/// One point of each cell whose diameter is at most `cell`.
class Enumerator {
  public:
    Enumerator(const Rifs& rifs, const std::vector<Bounds>& bounds,
               const std::vector<Points>& inner)
        : rifs_(rifs), bounds_(bounds), inner_(inner) {}

    /// Nothing if the limits do not allow it.
    std::optional<Points> points(double cell) {
        Points result;
        std::vector<Cell> open{{Affine{}, rifs_.start}};
        long visits = 0;
        while (!open.empty()) {
            const Cell top = open.back();
            open.pop_back();
            if (2 * bounds_[top.set].ball.radius * lipschitz_constant(top.place) <= cell) {
                result.push_back(top.place.point(inner_[top.set].front()));
                if (static_cast<long>(result.size()) > leaf_limit) return std::nullopt;
                continue;
            }
            const std::vector<int>& maps = rifs_.follow_sets[top.set].maps;
            visits += static_cast<long>(maps.size());
            if (visits > visit_limit) return std::nullopt;
            for (const int m : maps) {
                open.push_back({then(rifs_.maps[m], top.place), rifs_.follow_of[m]});
            }
        }
        return result;
    }

  private:
    struct Cell {
        Affine place;
        int set;
    };
    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    const std::vector<Points>& inner_;
};

/// A walk that forgets its past slowly stays in a part of the attractor.
bool walk_is_long_enough(const Rifs& rifs) {
    constexpr double forgetting_times = 1000;
    double log_lip = 0;  // mean over the maps
    for (const Affine& map : rifs.maps) {
        const double lip = std::max(lipschitz_constant(map), 1e-300);
        log_lip += std::log(lip) / static_cast<double>(rifs.maps.size());
    }
    return -log_lip * static_cast<double>(random_points) >= forgetting_times;
}

/// Random maps on the outside of a point of the attractor lead through the attractor, where every
/// map may stand anywhere.
Points random_walk(const Rifs& rifs, const Points& inner) {
    std::mt19937_64 random(1);  // a fixed seed: the same scene gives the same numbers
    Points result;
    glm::dvec3 point = inner.front();
    for (long n = 0; n < random_points; ++n) {
        point = rifs.maps[random() % rifs.maps.size()].point(point);
        result.push_back(point);
    }
    return result;
}

long occupied(const Points& points, const glm::dvec3& origin, double side) {
    constexpr unsigned bits = 21;  // of one coordinate
    std::vector<std::uint64_t> keys;
    keys.reserve(points.size());
    for (const glm::dvec3& point : points) {
        const glm::dvec3 place = glm::max(glm::floor((point - origin) / side), 0.0);
        keys.push_back((static_cast<std::uint64_t>(place.x) << 2 * bits) |
                       (static_cast<std::uint64_t>(place.y) << bits) |
                       static_cast<std::uint64_t>(place.z));
    }
    std::ranges::sort(keys);
    return std::unique(keys.begin(), keys.end()) - keys.begin();
}

/// The smaller of two grids' counts: the dimension is defined by the smallest cover.
long boxes_needed(const Points& points, const Box& box, double side) {
    return std::min(occupied(points, box.low - side / 2, side),
                    occupied(points, box.low - side * 1e-3, side));
}

/// Least squares; the slope's standard error from the residues.
void fit_line(BoxCounting& result) {
    const double n = static_cast<double>(result.scales.size());
    double mean_x = 0;
    double mean_y = 0;
    for (const BoxScale& scale : result.scales) {
        mean_x -= std::log(scale.side) / n;
        mean_y += std::log(static_cast<double>(scale.boxes)) / n;
    }
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const BoxScale& scale : result.scales) {
        const double x = -std::log(scale.side) - mean_x;
        const double y = std::log(static_cast<double>(scale.boxes)) - mean_y;
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    result.dimension = xy / xx;
    result.error = std::sqrt(std::max(yy - xy * xy / xx, 0.0) / (n - 2) / xx);
}

/// The finest cells that the limits allow, in steps of a factor of sqrt 2.
double finest_affordable(Enumerator& enumerator, double size, Points& points) {
    double cell = 2 * size;
    while (cell > finest_cell * size) {
        const double finer = cell / step;
        auto found = enumerator.points(finer);
        if (!found) break;
        points = std::move(*found);
        cell = finer;
    }
    return cell;
}

/// Random points have found all boxes if half of them find nearly as many.
bool is_sampled(const Points& points, const Box& box, double side, long boxes) {
    constexpr double nearly = 0.97;
    const Points half(points.begin(), points.begin() + static_cast<long>(points.size() / 2));
    return static_cast<double>(boxes_needed(half, box, side)) >=
           nearly * static_cast<double>(boxes);
}

void count_cells(const Points& points, const Box& box, double size, double cell,
                 BoxCounting& result) {
    for (double side = largest_side * size; side >= cells_a_side * cell; side /= step) {
        result.scales.push_back({side, boxes_needed(points, box, side)});
    }
}

void count_walk(const Points& points, const Box& box, double size, BoxCounting& result) {
    for (double side = largest_side * size; side >= finest_cell * size; side /= step) {
        const long boxes = boxes_needed(points, box, side);
        if (!is_sampled(points, box, side, boxes)) break;
        result.scales.push_back({side, boxes});
    }
}

/// Coarse grids show the outline more than what is inside of it.
void drop_coarse_scales(std::vector<BoxScale>& scales) {
    constexpr std::size_t plenty = 8;
    if (scales.size() <= plenty) return;
    scales.erase(scales.begin(), scales.begin() + static_cast<long>(scales.size() / 3));
}

}  // namespace

BoxCounting count_boxes(const Rifs& rifs, const std::vector<Bounds>& bounds) {
    const Box& box = bounds[rifs.start].box;
    const glm::dvec3 extent = box.high - box.low;
    const double size = std::max({extent.x, extent.y, extent.z});
    const std::vector<Points> inner = inner_points(rifs);
    const double places = glm::length(glm::max(glm::abs(box.low), glm::abs(box.high)));
    BoxCounting result;
    if (size <= 1e-9 * places || size == 0) {
        result.dimension = 0;
        result.points = 1;
        result.method = "the attractor is one point";
        return result;
    }
    Enumerator enumerator(rifs, bounds, inner);
    Points points;
    const double cell = finest_affordable(enumerator, size, points);
    if (cell <= coarsest_cell * size) {
        result.method = "a point of every cell of one size";
        count_cells(points, box, size, cell, result);
    }
    if (result.scales.size() < fewest_scales && rifs.follow_sets.size() == 1 &&
        walk_is_long_enough(rifs)) {
        result.scales.clear();
        result.method = "points of a random walk: there are too many cells";
        points = random_walk(rifs, inner[rifs.start]);
        count_walk(points, box, size, result);
    }
    result.points = static_cast<long>(points.size());
    if (result.scales.size() < fewest_scales) {
        result.scales.clear();
        result.method = "not measured: more cells than the limit of 170000 at the coarsest scales";
        return result;
    }
    drop_coarse_scales(result.scales);
    fit_line(result);
    return result;
}

}  // namespace pxm::host
