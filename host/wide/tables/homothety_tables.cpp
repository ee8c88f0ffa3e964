#include "host/wide/tables/homothety_tables.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host/math/lipschitz.hpp"

namespace pxm::host::wide {

namespace {

constexpr double rounding = 1e-6;
constexpr double largest_ratio = 0.9;  // an entry cell's paths are at most most_levels_below long
// Systems with very many follow sets have tables of several levels for some of them only.
constexpr std::size_t most_composed = std::size_t{1} << 18;
// Each way of being turned may have a table of each set.
constexpr std::size_t most_turned_sets = std::size_t{1} << 16;

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
    const auto step = [&](int axis) { return set.f64.row(ChildField::linear + 4 * axis)[lane]; };
    for (int axis = 1; axis < 3; ++axis) {
        if (std::abs(step(axis) - step(0)) > rounding * step(0)) return 0;
    }
    return 1 / step(0);
}

/// Where the child's centre is in the parent's unit coordinates: what K takes to 0.
glm::dvec3 center_of(const WideSet& set, int lane) {
    glm::dvec3 center;
    for (int axis = 0; axis < 3; ++axis) {
        center[axis] = -set.f64.row(ChildField::offset + axis)[lane] /
                       set.f64.row(ChildField::linear + 4 * axis)[lane];
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

/// A cell some levels down.
struct Step {
    int set;
    std::array<std::uint16_t, HomothetyTable::most_steps> lanes;
    glm::dvec3 center;
    double scale;
    double constant;
    double diameter;  // of the volume, times the constant
};

std::vector<Step> steps_of(const WideScene& scene, int set_index) {
    const WideSet& set = scene.sets[static_cast<std::size_t>(set_index)];
    std::vector<Step> steps;
    for (int lane = 0; lane < set.count; ++lane) {
        const double constant = set.f64.row(ChildField::constant)[lane];
        steps.push_back({set.sets[static_cast<std::size_t>(lane)],
                         {static_cast<std::uint16_t>(lane)},
                         center_of(set, lane),
                         scale_of(set, lane),
                         constant,
                         constant * set.f64.row(ChildField::diameter)[lane]});
    }
    return steps;
}

HomothetyTable table_of(const std::vector<Step>& cells, int steps, double least_skipped) {
    HomothetyTable table;
    table.count = static_cast<int>(cells.size());
    table.stride = (table.count + table_step - 1) / table_step * table_step;
    table.steps = steps;
    table.least_skipped = static_cast<float>(least_skipped);
    table.rows = LaneTable<float>(HomothetyTable::row_count, table.stride);
    table.f64 = LaneTable<double>(HomothetyTable::row_count, table.stride);
    for (const Step& cell : cells) {
        const auto lane = table.lanes.size();
        const auto row = [&](int i, double x) {
            table.rows.row(i)[lane] = static_cast<float>(x);
            table.f64.row(i)[lane] = x;
        };
        for (int axis = 0; axis < 3; ++axis) row(HomothetyTable::center + axis, cell.center[axis]);
        row(HomothetyTable::scale, cell.scale);
        row(HomothetyTable::constant, cell.constant);
        row(HomothetyTable::diameter, cell.diameter);
        table.most_diameter = std::max(table.most_diameter, static_cast<float>(cell.diameter));
        table.sets.push_back(cell.set);
        table.lanes.push_back(cell.lanes);
    }
    return table;
}

/// The children of all the cells; nothing if there are more than `most`.
std::vector<Step> one_step_on(const WideScene& scene, const std::vector<Step>& cells, int steps,
                              std::size_t most) {
    std::vector<Step> inner;
    for (const Step& cell : cells) {
        for (Step next : steps_of(scene, cell.set)) {
            if (inner.size() == most) return {};
            const std::uint16_t lane = next.lanes[0];
            next.lanes = cell.lanes;
            next.lanes[static_cast<std::size_t>(steps)] = lane;
            next.center = cell.center + next.center * cell.scale;
            next.scale *= cell.scale;
            next.constant *= cell.constant;
            next.diameter *= cell.constant;
            inner.push_back(next);
        }
    }
    return inner;
}

/// Balls are listed by the places where they are seen (host/wide/tables/candidate_views.hpp), so
/// that there may be many of them.
void tabulate(WideScene& scene, int index) {
    constexpr std::size_t most_balls = 2048;
    constexpr double most_across = 10;  // lists of more than they would be long
    std::vector<Step> cells = steps_of(scene, index);
    WideSet& set = scene.sets[static_cast<std::size_t>(index)];
    const std::size_t most = set.spheres ? most_balls : std::size_t{table_step};
    set.children = table_of(cells, 1, 0);
    double least = std::numeric_limits<double>::infinity();  // diameter of those stepped over
    for (int steps = 2; steps <= HomothetyTable::most_steps && !cells.empty(); ++steps) {
        if (scene.composed_cells > most_composed) break;
        least = std::min(least, std::ranges::min(cells, {}, &Step::diameter).diameter);
        cells = one_step_on(scene, cells, steps - 1, most);
        double across = 0;  // of all cells, to their parent's
        for (const Step& cell : cells) across += cell.scale * cell.scale;
        if (set.spheres && cells.size() > table_step && across > most_across) break;
        if (!cells.empty()) set.composed.push_back(table_of(cells, steps, least));
        scene.composed_cells += cells.size();
    }
}

/// Numbers the ways in which objects with balls are turned. Where there are too many, what is
/// turned otherwise is no object of homotheties any more.
void find_turns(WideScene& scene) {
    constexpr double alike = 1e-9;
    const std::size_t most =
        std::max<std::size_t>(1, most_turned_sets / std::max<std::size_t>(1, scene.sets.size()));
    for (WideObject& object : scene.objects) {
        const bool alone = scene.sets[static_cast<std::size_t>(object.set)].count == 0;
        if (!object.of_homotheties || !object.spheres || alone) continue;
        glm::dmat3 turn;
        for (int axis = 0; axis < 3; ++axis) {
            turn[axis] = glm::normalize(object.to_unit.direction(glm::dmat3{1}[axis]));
        }
        const auto same = std::ranges::find_if(scene.turns, [&](const glm::dmat3& other) {
            return glm::length(turn[0] - other[0]) < alike &&
                   glm::length(turn[1] - other[1]) < alike &&
                   glm::length(turn[2] - other[2]) < alike;
        });
        if (same == scene.turns.end() && scene.turns.size() == most) {
            object.of_homotheties = false;
            continue;
        }
        object.turn = static_cast<int>(same - scene.turns.begin());
        if (same == scene.turns.end()) scene.turns.push_back(turn);
    }
    if (scene.turns.empty()) scene.turns.emplace_back(1.0);  // of objects without maps
}

/// Whether a cell may have more children than a ray keeps of one.
bool has_many_children(const WideScene& scene, int first) {
    std::vector<bool> seen(scene.sets.size(), false);
    std::vector<int> waiting{first};
    while (!waiting.empty()) {
        const auto at = static_cast<std::size_t>(waiting.back());
        waiting.pop_back();
        if (seen[at]) continue;
        seen[at] = true;
        const WideSet& set = scene.sets[at];
        if (set.count > opened_cell_room) return true;
        waiting.insert(waiting.end(), set.sets.begin(), set.sets.end());
    }
    return false;
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

/// Gives an object with grids the one that its sets have in common, if there is one.
void find_common(WideScene& scene, WideObject& object) {
    const auto same = std::ranges::find_if(scene.common_grids, [&](const CommonGrid& other) {
        return other.sets.front() == object.set;
    });
    if (same == scene.common_grids.end()) {
        CommonGrid grid = find_common_grid(scene.sets, object.set);
        if (grid.sets.empty()) return;
        object.common_grid = static_cast<int>(scene.common_grids.size());
        scene.common_grids.push_back(std::move(grid));
    } else {
        object.common_grid = static_cast<int>(same - scene.common_grids.begin());
    }
}

}  // namespace

bool is_of_homotheties(const CompiledScene& scene, const CompiledObject& object) {
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
        if (object.of_homotheties) waiting.push_back(object.set);
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
        if (!object.of_homotheties) continue;
        std::vector<bool> seen(scene.sets.size(), false);
        object.grid = !object.spheres && find_grids(scene, object.set, seen);
        if (object.grid) find_common(scene, object);
        if (!object.grid && has_many_children(scene, object.set)) object.of_homotheties = false;
    }
    find_turns(scene);
}

}  // namespace pxm::host::wide
