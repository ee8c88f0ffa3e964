#include "host/fractal/dimension/box_counting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "host/fractal/dimension/box_population.hpp"
#include "host/fractal/system/growth.hpp"
#include "host/process/in_threads.hpp"

namespace pxm::host {

namespace {

constexpr double step = std::numbers::sqrt2;  // from one scale to the next
constexpr double largest_side = 0.25;         // of the attractor's size
constexpr double smallest_side = 1e-6;
constexpr double largest_places = 1e100;  // as for objects: squares are within double
constexpr std::size_t fewest_scales = 9;
constexpr std::size_t populations = 8;
constexpr std::size_t pilots = 4;
constexpr std::size_t fewest_places = 12;  // of a population
constexpr std::size_t most_places = 96;
constexpr double most_work = 6e6;   // cells looked at
constexpr double first_work = 1e6;  // ... where that gives an error that is
constexpr double small_error = 0.02;
constexpr double of_larger_cells = 1.7;  // by which errors are larger where cells are
constexpr double no_range = 0.2;         // an error that tells no dimension
constexpr double least_error = 6e-3;     // what grids of all scales have in common

/// Numbers of boxes, one row a population.
using Counts = std::vector<std::vector<double>>;

/// Least squares: how log count rises from one scale to the next, in units of log resolution.
double slope(const std::vector<double>& boxes, std::size_t first, std::size_t last) {
    const double n = static_cast<double>(last - first);
    double mean = 0;
    for (std::size_t k = first; k < last; ++k) mean += std::log(boxes[k]) / n;
    double xx = 0;
    double xy = 0;
    for (std::size_t k = first; k < last; ++k) {
        const double x = static_cast<double>(k - first) - (n - 1) / 2;
        xx += x * x;
        xy += x * (std::log(boxes[k]) - mean);
    }
    return xy / xx / std::log(step);
}

std::vector<double> mean_of(const Counts& counts) {
    std::vector<double> mean(counts.front().size(), 0);
    for (const std::vector<double>& boxes : counts) {
        for (std::size_t k = 0; k < mean.size(); ++k) {
            mean[k] += boxes[k] / static_cast<double>(counts.size());
        }
    }
    return mean;
}

/// The standard error of the slope, from how the populations differ.
double spread(const Counts& counts, std::size_t first, std::size_t last) {
    double sum = 0;
    double squares = 0;
    for (const std::vector<double>& boxes : counts) {
        const double s = slope(boxes, first, last);
        sum += s;
        squares += s * s;
    }
    const double n = static_cast<double>(counts.size());
    return std::sqrt(std::max(squares - sum * sum / n, 0.0) / (n - 1) / n);
}

/// Coarse grids show the outline more than what is inside of it: they only tell how far the slope
/// still changes. So do the two halves of the others, which also differ where the attractor looks
/// alike at few scales alone.
void fit(const Counts& counts, bool similitudes, BoxCounting& result) {
    const std::vector<double> boxes = mean_of(counts);
    const std::size_t last = boxes.size();
    const std::size_t first = last / 3;
    const std::size_t middle = (first + last) / 2;
    const double coarse = slope(boxes, 0, first);
    const double near = slope(boxes, first, middle);
    const double fine = slope(boxes, middle, last);
    // Of the change from the coarse scales to the next; what squashes settles more slowly.
    const double remaining = similitudes ? 0.3 : 0.5;
    const double change = std::max(std::abs(fine - near), remaining * std::abs(near - coarse));
    // So that the error holds the dimension of 19 systems of 20, as it was tried: affine ones
    // change over more scales than there are.
    const double surely = similitudes ? 1.2 : 1.6;
    result.dimension = slope(boxes, first, last);
    result.error = std::max(least_error, surely * std::hypot(spread(counts, first, last), change));
}

std::vector<double> sides_for(double size) {
    std::vector<double> sides;
    for (double side = largest_side; side > smallest_side; side /= step) {
        sides.push_back(side * size);
    }
    return sides;
}

/// The counts at the first `scales` sides, or at fewer if there are too many cells.
std::vector<double> counts_of(BoxPopulation& population, const std::vector<double>& sides,
                              std::size_t scales, double work,
                              std::vector<long>* visits = nullptr) {
    std::vector<double> boxes;
    for (std::size_t k = 0; k < scales; ++k) {
        const double count = population.count(sides[k]);
        if (!(count > 0)) break;
        boxes.push_back(count);
        if (visits != nullptr) visits->push_back(population.visits());
        if (static_cast<double>(population.visits()) > work) break;
    }
    return boxes;
}

/// How many scales, and places of each population, the work allows.
struct Plan {
    std::size_t scales = 0;
    std::size_t places = 0;
};

Plan plan_for(const ZoomSystem& system, const std::vector<double>& sides, double work) {
    std::vector<long> visits;
    BoxPopulation pilot(system, pilots, 1);
    Plan plan;
    plan.scales = counts_of(pilot, sides, sides.size(), work, &visits).size();
    for (; plan.scales >= fewest_scales; --plan.scales) {
        const double of_a_place = static_cast<double>(visits[plan.scales - 1]) / pilots;
        const double places = work / populations / of_a_place;
        if (places < fewest_places) continue;
        plan.places = static_cast<std::size_t>(std::min<double>(places, most_places));
        break;
    }
    return plan;
}

void measure(const ZoomSystem& system, double size, int threads, double work, BoxCounting& result) {
    const std::vector<double> sides = sides_for(size);
    const Plan plan = plan_for(system, sides, work);
    result.method = "not measured: more cells than the limit allows to look at";
    if (plan.places == 0) return;
    Counts counts(populations);
    const std::atomic<bool> never = false;
    in_threads(threads, populations, never, [&](std::size_t p) {
        BoxPopulation population(system, plan.places, p + 2);
        counts[p] = counts_of(population, sides, plan.scales, work);
    });
    std::size_t scales = plan.scales;  // that all populations have
    for (const std::vector<double>& boxes : counts) scales = std::min(scales, boxes.size());
    if (scales < fewest_scales) return;
    for (std::vector<double>& boxes : counts) boxes.resize(scales);
    fit(counts, system.similitudes, result);
    result.points = static_cast<long>(populations * plan.places);
    if (result.error > no_range) {
        result.dimension.reset();
        result.error = 0;
        result.method = "not measured: no range of scales tells a dimension";
        return;
    }
    result.method = fmt::format("boxes around {} places", result.points);
    const std::vector<double> boxes = mean_of(counts);
    for (std::size_t k = 0; k < boxes.size(); ++k) result.scales.push_back({sides[k], boxes[k]});
}

}  // namespace

BoxCounting count_boxes(const Rifs& rifs, const std::vector<Bounds>& bounds, int threads) {
    const Box& box = bounds[rifs.start].box;
    const glm::dvec3 extent = box.high - box.low;
    const double size = std::max({extent.x, extent.y, extent.z});
    const double places = glm::length(glm::max(glm::abs(box.low), glm::abs(box.high)));
    BoxCounting result;
    if (!(places < largest_places)) {
        result.method = "not measured: the attractor is too large for it, or too far away";
        return result;
    }
    if (!branches(rifs) || size <= 1e-9 * places || size == 0) {
        result.dimension = 0;
        result.points = 1;
        result.method = branches(rifs) ? "the attractor is one point"
                                       : "the attractor is made of single points";
        return result;
    }
    // Where there are too many cells, larger ones are taken for points.
    ZoomSystem system(rifs, bounds);
    measure(system, size, threads, first_work, result);
    const bool all_scales = result.scales.size() == sides_for(size).size();
    if (result.dimension && all_scales && result.error <= small_error) return result;
    // Cells that are thin in any direction stay too many, however many are looked at.
    const bool more_helps = system.similitudes || system.layers;
    if (more_helps) {
        result = {};
        measure(system, size, threads, most_work, result);
    }
    if (result.dimension) return result;
    system.finest *= 2;
    measure(system, size, threads, more_helps ? most_work : first_work, result);
    result.error *= of_larger_cells;
    return result;
}

}  // namespace pxm::host
