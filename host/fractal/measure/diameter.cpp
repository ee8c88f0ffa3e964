#include "host/fractal/measure/diameter.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <queue>

#include "host/fractal/system/sensitivity.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr double tolerance = 1e-6;  // of the diameter
constexpr long budget = 100'000;    // pairs of cells
constexpr double rounding = 1e-12;  // of a cell's size, of composed maps

struct Cell {
    Affine map;
    int set = 0;
    glm::dvec3 center{0.0};
    double radius = 0;
    glm::dvec3 point{0.0};  // of the attractor
};

struct Pair {
    double upper = 0;
    Cell first;
    Cell second;
    bool operator<(const Pair& other) const { return upper < other.upper; }
};

class Search {
  public:
    Search(const Rifs& rifs, const std::vector<Bounds>& bounds,
           const std::vector<std::vector<glm::dvec3>>& inner)
        : rifs_(rifs), bounds_(bounds), inner_(inner) {}

    Diameter run() {
        const auto& points = inner_[static_cast<std::size_t>(rifs_.start)];
        for (const glm::dvec3& a : points)
            for (const glm::dvec3& b : points) know(a, b);
        const Cell whole = cell({}, rifs_.start);
        meet(whole, whole);
        long looked = 0;
        while (!pairs_.empty()) {
            const Pair pair = pairs_.top();
            found_.upper = pair.upper;
            if (pair.upper <= found_.value * (1 + tolerance) || looked > budget) break;
            // A system of many maps would make more pairs at once than are looked at in all.
            const bool both = maps_in(pair.first) * maps_in(pair.second) <= budget / 8;
            const bool first = both || pair.first.radius >= pair.second.radius;
            const bool second = both || !first;
            const long made =
                (first ? maps_in(pair.first) : 1) * (second ? maps_in(pair.second) : 1);
            if (looked + made > budget) break;
            pairs_.pop();
            for (const Cell& a : parts(pair.first, first)) {
                for (const Cell& b : parts(pair.second, second)) meet(a, b);
            }
            looked = count_;
        }
        found_.upper = std::max(found_.upper, found_.value);
        return found_;
    }

  private:
    [[nodiscard]] Cell cell(const Affine& map, int set) const {
        const auto s = static_cast<std::size_t>(set);
        const Ball& ball = bounds_[s].ball;
        const double lip = lipschitz_constant(map);
        const glm::dvec3 center = map.point(ball.center);
        return {map, set, center,
                (lip * ball.radius + rounding * glm::length(center)) * (1 + rounding),
                map.point(inner_[s].front())};
    }

    [[nodiscard]] long maps_in(const Cell& of) const {
        return std::ssize(rifs_.follow_sets[static_cast<std::size_t>(of.set)].maps);
    }

    /// Its children, or the cell as it is.
    [[nodiscard]] std::vector<Cell> parts(const Cell& of, bool divided) const {
        if (!divided) return {of};
        std::vector<Cell> cells;
        for (const int m : rifs_.follow_sets[static_cast<std::size_t>(of.set)].maps)
            cells.push_back(cell(then(rifs_.maps[static_cast<std::size_t>(m)], of.map),
                                 rifs_.follow_of[static_cast<std::size_t>(m)]));
        return cells;
    }

    void know(const glm::dvec3& a, const glm::dvec3& b) {
        const double far = glm::distance(a, b);
        if (far <= found_.value) return;
        found_.value = far;
        found_.between = {a, b};
    }

    void meet(const Cell& a, const Cell& b) {
        ++count_;
        know(a.point, b.point);
        const double upper = glm::distance(a.center, b.center) + a.radius + b.radius;
        if (upper > found_.value) pairs_.push({upper, a, b});
    }

    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    const std::vector<std::vector<glm::dvec3>>& inner_;
    std::priority_queue<Pair> pairs_;
    Diameter found_;
    long count_ = 0;
};

}  // namespace

Diameter diameter(const Rifs& rifs, const std::vector<Bounds>& bounds,
                  const std::vector<std::vector<glm::dvec3>>& inner) {
    constexpr double of_a_map = 1e-15;  // what rounding moves an image by, of places
    Diameter found = Search(rifs, bounds, inner).run();
    double farthest = 0;
    for (const Bounds& b : bounds)
        farthest = std::max(farthest, glm::length(b.ball.center) + b.ball.radius);
    // A point that maps' rounded images lead to is that near to one that their own lead to.
    const double off = sensitivity(rifs).lipschitz * of_a_map * farthest;
    found.lower = std::max(0.0, found.value - 2 * off - rounding * found.value);
    return found;
}

}  // namespace pxm::host
