#include "host/node_program/crowded.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"

namespace pxm::host {

namespace {

constexpr int points = 4;               // of the attractor, that are looked around
constexpr long many = 1000;             // cells around a point
constexpr long most_cells = 10 * many;  // enough to be sure
constexpr long most_tests = 200'000;    // of maps by the thousand
constexpr double alike = 4;             // words to a cell
constexpr double steps_a_cell = 8;      // of the smallest cells: nearer ones are the same

/// A cell on the way down to a point.
struct CellAround {
    Affine place;      // cell to shape coordinates
    glm::dvec3 point;  // in the cell's coordinates
    int set;
};

/// About the constant of a map: exact for similitudes, and never more.
double mean_constant(const glm::dmat3& linear) {
    double squares = 0;
    for (int i = 0; i < 3; ++i) squares += glm::dot(linear[i], linear[i]);
    return std::sqrt(squares / 3);
}

/// Counts the cells of a shape around points of its attractor. Its volumes may be loose: what is
/// inside a map is taken to be a ball around some points of it.
class CrowdCount {
  public:
    explicit CrowdCount(const CompiledShape& shape) : shape_(shape), balls_(shape.sets.size()) {
        for (const CompiledMap& map : shape.maps) back_.push_back(inverse(map.map));
    }

    /// A point of what may follow in a set, at the end of a long word.
    [[nodiscard]] glm::dvec3 point_of(int set, int number) const {
        constexpr int levels = 200;
        constexpr double small = 1e-9;
        Affine place;
        auto bits = static_cast<std::uint64_t>(number + 1);
        for (int level = 0; level < levels && mean_constant(place.linear) > small; ++level) {
            bits = bits * 6364136223846793005U + 1442695040888963407U;
            const std::vector<int>& maps = maps_of(set);
            const CompiledMap& map = map_of(maps[(bits >> 33U) % maps.size()]);
            place = then(map.map, place);
            set = map.follow_set;
        }
        return place.point(shape_.sets[static_cast<std::size_t>(set)].volume.center);
    }
    /// Made when it is asked for: of ten thousand sets few are met.
    [[nodiscard]] const Ball& ball(int set) {
        std::optional<Ball>& known = balls_[static_cast<std::size_t>(set)];
        if (!known) known = ball_of(set);
        return *known;
    }

    /// Cells around the point that are larger than `smallest`, up to most_cells. Those alike are
    /// counted once if `known` is given.
    [[nodiscard]] long count(const glm::dvec3& point, double smallest, KnownCells* known) {
        if (known != nullptr) known->forget();
        std::vector<CellAround> open{{Affine{}, point, shape_.start}};
        long count = 0;
        long tests = 0;
        while (!open.empty() && count < most_cells && tests < most_tests) {
            const CellAround cell = open.back();
            open.pop_back();
            if (mean_constant(cell.place.linear) * 2 * ball(cell.set).radius <= smallest) continue;
            if (known != nullptr && known->contains(sketch(cell, smallest), 0, 0)) continue;
            ++count;
            tests += static_cast<long>(maps_of(cell.set).size());
            for (const int symbol : maps_of(cell.set)) {
                const CompiledMap& map = map_of(symbol);
                const Ball& around = ball(map.follow_set);
                const glm::dvec3 inside = back_[static_cast<std::size_t>(symbol)].point(cell.point);
                if (!(glm::distance(inside, around.center) <= around.radius)) continue;
                open.push_back({then(map.map, cell.place), inside, map.follow_set});
            }
        }
        return count;
    }

  private:
    [[nodiscard]] const std::vector<int>& maps_of(int set) const {
        return shape_.sets[static_cast<std::size_t>(set)].maps;
    }
    [[nodiscard]] const CompiledMap& map_of(int symbol) const {
        return shape_.maps[static_cast<std::size_t>(symbol)];
    }
    [[nodiscard]] Ball ball_of(int set) const {
        constexpr int number = 24;
        constexpr double room = 1.25;  // for what lies between the points
        std::vector<glm::dvec3> inner;
        Ball ball;
        for (int i = 0; i < number; ++i) {
            inner.push_back(point_of(set, i));
            ball.center += inner.back() / static_cast<double>(number);
        }
        for (const glm::dvec3& point : inner) {
            ball.radius = std::max(ball.radius, room * glm::distance(point, ball.center));
        }
        return ball;
    }
    [[nodiscard]] CellSketch sketch(const CellAround& cell, double smallest) {
        const Ball& inside = ball(cell.set);
        const double per_length = steps_a_cell / smallest;
        CellSketch sketch;
        sketch.add(static_cast<std::uint64_t>(cell.set));
        const glm::dvec3 center = cell.place.point(inside.center);
        for (int i = 0; i < 3; ++i) {
            sketch.add(center[i], per_length);
            for (int k = 0; k < 3; ++k) {
                sketch.add(cell.place.linear[i][k], per_length * inside.radius);
            }
        }
        return sketch;
    }

    const CompiledShape& shape_;
    std::vector<Affine> back_;
    std::vector<std::optional<Ball>> balls_;
};

}  // namespace

bool is_crowded(const CompiledShape& shape) {
    if (shape.maps.empty() || shape.lifted) return false;
    CrowdCount crowd(shape);
    std::vector<glm::dvec3> places;
    for (int i = 0; i < points; ++i) places.push_back(crowd.point_of(shape.start, i));
    const double whole = 2 * crowd.ball(shape.start).radius;
    for (const double parts : {8.0, 16.0, 32.0, 64.0, 128.0, 256.0}) {
        const auto sum = [&](KnownCells* known) {
            double cells = 0;
            for (const glm::dvec3& place : places) {
                cells += static_cast<double>(crowd.count(place, whole / parts, known));
            }
            return cells;
        };
        const double words = sum(nullptr);
        if (words < static_cast<double>(points * many)) continue;
        KnownCells known;
        return words >= alike * sum(&known);
    }
    return false;
}

double known_share(const CompiledScene& scene) {
    constexpr double most = 0.5, least = 0x1p-12;  // of a pixel
    constexpr double narrow = 0.1;  // a map that shrinks by less is followed by many like it
    double share = 0;
    for (const CompiledObject& object : scene.objects) {
        const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
        if (!shape.crowded) continue;
        if (share == 0) share = most;
        for (const CompiledMap& map : shape.maps)
            share = std::min(share, most * std::max((1 - map.constant) / narrow, least));
    }
    return share;
}

bool has_crowded_objects(const CompiledScene& scene) {
    return std::ranges::any_of(scene.objects, [&](const CompiledObject& object) {
        return scene.shapes[static_cast<std::size_t>(object.shape)].crowded;
    });
}

}  // namespace pxm::host
