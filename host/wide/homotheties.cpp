#include "host/wide/homotheties.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/fractal/lipschitz.hpp"

namespace pxm::host::wide {

namespace {

constexpr double rounding = 1e-6;
constexpr double largest_ratio = 0.9;  // a start cell's paths are at most Found::most_below long

bool is_homothety(const Affine& map) {
    const double ratio = map.linear[0][0];
    if (!(ratio > 0 && ratio <= largest_ratio)) return false;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double expected = i == j ? ratio : 0;
            if (std::abs(map.linear[i][j] - expected) > 1e-12 * ratio) return false;
        }
    }
    return true;
}

/// The one scale of a child to its parent in unit coordinates; 0 if axes have scales of their own.
double scale_of(const WideSet& set, int lane) {
    const auto step = [&](int axis) { return set.twice.row(ChildField::linear + 4 * axis)[lane]; };
    for (int axis = 1; axis < 3; ++axis) {
        if (std::abs(step(axis) - step(0)) > rounding * step(0)) return 0;
    }
    return 1 / step(0);
}

/// Where the child's centre is in the parent's unit coordinates: what K takes to 0.
glm::dvec3 center_of(const WideSet& set, int lane) {
    glm::dvec3 center;
    for (int axis = 0; axis < 3; ++axis) {
        center[axis] = -set.twice.row(ChildField::offset + axis)[lane] /
                       set.twice.row(ChildField::linear + 4 * axis)[lane];
    }
    return center;
}

bool lies_within(const CompiledVolume& inner, const CompiledVolume& outer, const Affine& map) {
    const double ratio = map.linear[0][0];
    const double slack = rounding * outer.diameter;
    const glm::dvec3 offset = map.point(inner.center) - outer.center;
    if (outer.kind == kernels::Volume::sphere) {
        return std::sqrt(glm::dot(offset, offset)) + ratio * inner.radius <= outer.radius + slack;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double half = (inner.high[axis] - inner.low[axis]) / 2 * ratio;
        const double room = (outer.high[axis] - outer.low[axis]) / 2 + slack;
        if (std::abs(offset[axis]) + half > room) return false;
    }
    return true;
}

bool same_shape(const CompiledVolume& a, const CompiledVolume& b) {
    if (a.kind != b.kind || a.kind == kernels::Volume::oriented) return false;
    if (a.kind == kernels::Volume::sphere) return true;
    const glm::dvec3 p = (a.high - a.low) / a.diameter;
    const glm::dvec3 q = (b.high - b.low) / b.diameter;
    return glm::length(p - q) <= rounding;
}

struct Step {
    int set;
    int lane;
    glm::dvec3 center;
    double scale;
    double constant;
    double diameter;  // of the volume, times the constant
};

std::vector<Step> steps_of(const WideScene& scene, int set_index) {
    const WideSet& set = scene.sets[static_cast<std::size_t>(set_index)];
    std::vector<Step> steps;
    for (int lane = 0; lane < set.count; ++lane) {
        const double constant = set.twice.row(ChildField::constant)[lane];
        steps.push_back({set.sets[static_cast<std::size_t>(lane)], lane, center_of(set, lane),
                         scale_of(set, lane), constant,
                         constant * set.twice.row(ChildField::diameter)[lane]});
    }
    return steps;
}

HomothetyTable empty_table(std::size_t count, int steps) {
    HomothetyTable table;
    table.count = static_cast<int>(count);
    table.stride = (table.count + table_step - 1) / table_step * table_step;
    table.steps = steps;
    table.rows = LaneTable<float>(HomothetyTable::row_count, table.stride);
    table.twice = LaneTable<double>(HomothetyTable::row_count, table.stride);
    return table;
}

void put(HomothetyTable& table, int lane, const Step& step) {
    const auto row = [&](int i, double x) {
        table.rows.row(i)[lane] = static_cast<float>(x);
        table.twice.row(i)[lane] = x;
    };
    for (int axis = 0; axis < 3; ++axis) row(HomothetyTable::center + axis, step.center[axis]);
    row(HomothetyTable::scale, step.scale);
    row(HomothetyTable::constant, step.constant);
    row(HomothetyTable::diameter, step.diameter);
    table.sets.push_back(step.set);
}

void tabulate(WideScene& scene, int index) {
    const std::vector<Step> outer = steps_of(scene, index);
    HomothetyTable children = empty_table(outer.size(), 1);
    std::size_t pairs = 0;
    for (const Step& step : outer) {
        put(children, static_cast<int>(children.lanes.size()), step);
        children.lanes.push_back({static_cast<std::uint16_t>(step.lane), 0});
        pairs += static_cast<std::size_t>(scene.sets[static_cast<std::size_t>(step.set)].count);
    }
    WideSet& set = scene.sets[static_cast<std::size_t>(index)];
    set.children = std::move(children);
    if (pairs == 0 || pairs > table_step) return;
    HomothetyTable both = empty_table(pairs, 2);
    both.least_skipped = static_cast<float>(std::ranges::min(outer, {}, &Step::diameter).diameter);
    for (const Step& first : outer) {
        for (Step second : steps_of(scene, first.set)) {
            const auto lane = static_cast<std::uint16_t>(second.lane);
            second.center = first.center + second.center * first.scale;
            second.scale *= first.scale;
            second.constant *= first.constant;
            second.diameter *= first.constant;
            put(both, static_cast<int>(both.lanes.size()), second);
            both.lanes.push_back({static_cast<std::uint16_t>(first.lane), lane});
        }
    }
    set.grandchildren = std::move(both);
}

/// The fixed points of the maps, if the attractor is inside of their hull, and the hull a cull.
std::vector<glm::dvec3> hull_points(const WideScene& scene, const WideObject& object) {
    constexpr double outside = 1 + rounding;
    const WideSet& set = scene.sets[static_cast<std::size_t>(object.set)];
    const bool alone = std::ranges::all_of(set.sets, [&](int s) { return s == object.set; });
    if (!object.spheres || !alone || object.levels != kernels::unlimited_levels) return {};
    std::vector<glm::dvec3> points;
    for (const Step& step : steps_of(scene, object.set)) {
        points.push_back(step.center / (1 - step.scale));
        if (glm::length(points.back()) > outside) return {};  // a ball that bounds nothing
    }
    if (points.size() > WideObject::most_hull_points) return {};
    return points;
}

/// Gives the sets of an object of boxes their grids. False if a set has none.
bool find_grids(WideScene& scene, int first, std::vector<bool>& seen) {
    const auto at = static_cast<std::size_t>(first);
    if (seen[at]) return true;
    seen[at] = true;
    WideSet& set = scene.sets[at];
    if (set.grid.empty()) set.grid = find_grid(set.children);
    return !set.grid.empty() &&
           std::ranges::all_of(set.sets, [&](int inner) { return find_grids(scene, inner, seen); });
}

}  // namespace

bool has_fixed_direction(const CompiledScene& scene, const CompiledObject& object) {
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
    if (shape.lipschitz == kernels::Lipschitz::polar) return false;
    if (singular_values(object.instance.linear).values[2] <
        (1 - rounding) * singular_values(object.instance.linear).values[0]) {
        return false;
    }
    return std::ranges::all_of(shape.sets, [&](const CompiledSet& set) {
        return same_shape(set.volume, shape.sets[0].volume) &&
               std::ranges::all_of(set.maps, [&](int symbol) {
                   const CompiledMap& map = shape.maps[static_cast<std::size_t>(symbol)];
                   const auto inner = static_cast<std::size_t>(map.follow_set);
                   return is_homothety(map.map) &&
                          lies_within(shape.sets[inner].volume, set.volume, map.map);
               });
    });
}

void tabulate_homotheties(WideScene& scene) {
    std::vector<bool> done(scene.sets.size(), false);
    std::vector<int> waiting;
    for (const WideObject& object : scene.objects) {
        if (object.fixed_direction) waiting.push_back(object.set);
    }
    while (!waiting.empty()) {
        const int index = waiting.back();
        waiting.pop_back();
        if (done[static_cast<std::size_t>(index)]) continue;
        done[static_cast<std::size_t>(index)] = true;
        tabulate(scene, index);
        const std::vector<int>& next = scene.sets[static_cast<std::size_t>(index)].sets;
        waiting.insert(waiting.end(), next.begin(), next.end());
    }
    for (WideObject& object : scene.objects) {
        if (!object.fixed_direction) continue;
        object.hull = hull_points(scene, object);
        std::vector<bool> seen(scene.sets.size(), false);
        object.grid = !object.spheres && find_grids(scene, object.set, seen);
    }
}

}  // namespace pxm::host::wide
