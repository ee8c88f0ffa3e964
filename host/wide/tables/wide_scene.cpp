#include "host/wide/tables/wide_scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/engine/gather.hpp"
#include "host/math/lipschitz.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "host/wide/tables/candidate_views.hpp"
#include "host/wide/tables/eligible.hpp"
#include "host/wide/tables/homothety_tables.hpp"

namespace pxm::host::wide {

namespace {

/// From the unit coordinates of a volume, in which it is the unit ball or the cube [-1,1]^3.
Affine from_unit(const CompiledVolume& volume) {
    const double least = thinnest * volume.diameter;
    const glm::dvec3 half = glm::max((volume.high - volume.low) / 2.0, least);
    switch (volume.kind) {
        case kernels::Volume::sphere:
            return {glm::dmat3{volume.radius}, volume.center};
        case kernels::Volume::oriented:
            return {glm::dmat3{volume.half[0], volume.half[1], volume.half[2]}, volume.center};
        default:
            return {glm::dmat3{half.x, 0, 0, 0, half.y, 0, 0, 0, half.z}, volume.center};
    }
}

/// First `map`, then into the unit coordinates of `volume`.
Affine into_unit(const Affine& map, const CompiledVolume& volume) {
    return then(map, inverse(from_unit(volume)));
}

template <class T>
void write_child(LaneTable<T>& table, int lane, const Affine& step, const CompiledMap& map,
                 double diameter) {
    const auto put = [&](int row, double value) { table.row(row)[lane] = static_cast<T>(value); };
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            put(ChildField::linear + 3 * i + j, step.linear[i][j]);
            put(ChildField::forward + 3 * i + j, map.map.linear[i][j]);
        }
        put(ChildField::offset + i, step.translation[i]);
    }
    put(ChildField::constant, map.constant);
    put(ChildField::diameter, diameter);
}

/// 1 over the half width of a volume along the axes of its unit coordinates.
glm::dvec3 inverse_half(const CompiledVolume& volume) {
    const glm::dmat3 linear = from_unit(volume).linear;
    return {1 / glm::length(linear[0]), 1 / glm::length(linear[1]), 1 / glm::length(linear[2])};
}

/// `step` is K, from the parent's unit coordinates to the child's.
void write_beam(LaneTable<double>& table, int lane, const Affine& step,
                const CompiledVolume& inner) {
    const Affine outward = inverse(step);
    const glm::dvec3 half = inverse_half(inner);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            table.row(BeamField::linear + 3 * i + j)[lane] = outward.linear[i][j];
        }
        table.row(BeamField::offset + i)[lane] = outward.translation[i];
        table.row(BeamField::inverse_half + i)[lane] = half[i];
    }
    table.row(BeamField::box)[lane] = inner.kind == kernels::Volume::box ? 1 : 0;
}

WideSet make_set(const CompiledScene& scene, const CompiledShape& shape, const CompiledSet& set,
                 int first_set) {
    WideSet wide;
    wide.coverage = set.coverage;
    wide.count = static_cast<int>(set.maps.size());
    wide.stride = (wide.count + table_step - 1) / table_step * table_step;
    wide.polar = shape.lipschitz == kernels::Lipschitz::polar;
    wide.f64 = LaneTable<double>(ChildField::count, wide.stride);
    wide.f32 = LaneTable<float>(ChildField::count, wide.stride);
    if (scene.area) wide.beams = LaneTable<double>(BeamField::count, wide.stride);
    for (int lane = 0; lane < wide.count; ++lane) {
        const int symbol = set.maps[static_cast<std::size_t>(lane)];
        const CompiledMap& map = shape.maps[static_cast<std::size_t>(symbol)];
        const CompiledVolume& inner = shape.sets[static_cast<std::size_t>(map.follow_set)].volume;
        const Affine step = into_unit(then(from_unit(set.volume), inverse(map.map)), inner);
        write_child(wide.f64, lane, step, map, inner.diameter);
        write_child(wide.f32, lane, step, map, inner.diameter);
        if (scene.area) write_beam(wide.beams, lane, step, inner);
        wide.maps.push_back(symbol);
        wide.colors.push_back({static_cast<float>(map.color.r), static_cast<float>(map.color.g),
                               static_cast<float>(map.color.b), static_cast<float>(map.color.a)});
        wide.sets.push_back(first_set + map.follow_set);
        wide.spheres = inner.kind == kernels::Volume::sphere;
    }
    return wide;
}

std::array<float, 3> floats(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// The diameter of the outermost cell around an object; 0 if none is.
double widest_around(const CompiledScene& scene, const CompiledObject& object) {
    double widest = 0;
    for (int at = object.enclosing; at >= 0;) {
        const CompiledEnclosure& cell = scene.enclosures[static_cast<std::size_t>(at)];
        widest = cell.volume.diameter;
        at = cell.enclosing;
    }
    return widest;
}

/// Object `i` of the scene; `first_set` is where its shape's sets begin.
WideObject make_object(const CompiledScene& scene, std::size_t i, int first_set) {
    const CompiledObject& object = scene.objects[i];
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
    const CompiledVolume& volume = shape.sets[static_cast<std::size_t>(object.start)].volume;
    WideObject result;
    result.index = static_cast<int>(i);
    result.to_unit = into_unit(inverse(object.instance), volume);
    result.from_unit = inverse(result.to_unit);
    result.linear = object.instance.linear;
    result.set = first_set + object.start;
    result.spheres = volume.kind == kernels::Volume::sphere;
    result.constant = object.constant;
    result.diameter = volume.diameter;
    result.inverse_half = inverse_half(volume);
    result.box = volume.kind == kernels::Volume::box;
    result.smallest_pixel = smallest_pixel_share<double>() * object.diameter;
    result.levels = object.levels;
    result.hash = hash_symbols(object.prefix);
    result.enclosing = object.enclosing;
    result.widest = widest_around(scene, object);
    result.colored =
        std::ranges::any_of(shape.maps, [](const CompiledMap& map) { return map.color.a > 0; });
    result.color = floats(object.color);
    result.diffuse = static_cast<float>(object.diffuse);
    result.reflect = static_cast<float>(object.reflect);
    result.center = object.instance.point(volume.center);
    result.radius = lipschitz_constant(object.instance) * volume.radius;
    result.of_homotheties = is_of_homotheties(scene, object);
    return result;
}

}  // namespace

WideScene make_wide_scene(const CompiledScene& scene) {
    WideScene wide;
    wide.camera = scene.camera;
    wide.size = scene.size;
    wide.candidate_view_side = candidate_view_side(scene.camera, scene.size);
    wide.detail = scene.detail;
    wide.cell_cap = scene.cell_cap;
    wide.unit = scene.unit;
    wide.shading = scene.shading;
    wide.ambient = floats(scene.ambient);
    wide.background = floats(scene.background);
    wide.lights = scene.lights;
    wide.enclosures = scene.enclosures;
    wide.why_not = why_not_objects(scene);
    std::vector<int> first_sets;
    std::vector<bool> in_use(scene.shapes.size(), false);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (!wide.why_not[i].empty()) continue;
        in_use[static_cast<std::size_t>(scene.objects[i].shape)] = true;
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        first_sets.push_back(static_cast<int>(wide.sets.size()));
        if (!in_use[i]) continue;
        for (const CompiledSet& set : scene.shapes[i].sets) {
            wide.sets.push_back(make_set(scene, scene.shapes[i], set, first_sets.back()));
        }
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (!wide.why_not[i].empty()) continue;
        const auto shape = static_cast<std::size_t>(scene.objects[i].shape);
        wide.objects.push_back(make_object(scene, i, first_sets[shape]));
    }
    tabulate_homotheties(wide);
    return wide;
}

}  // namespace pxm::host::wide
