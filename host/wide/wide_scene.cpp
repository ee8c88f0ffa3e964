#include "host/wide/wide_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "host/fractal/lipschitz.hpp"
#include "host/render/scene_block.hpp"
#include "host/wide/homotheties.hpp"

namespace pxm::host::wide {

namespace {

constexpr double thinnest = 1e-7;  // half width of a box, of its diameter

/// The half widths of a volume: unit coordinates are (x - center) / half.
glm::dvec3 half_of(const CompiledVolume& volume) {
    if (volume.kind == kernels::Volume::sphere) return glm::dvec3{volume.radius};
    return glm::max((volume.high - volume.low) / 2.0, thinnest * volume.diameter);
}

/// First `map`, then into the unit coordinates of `volume`.
Affine into_unit(const Affine& map, const CompiledVolume& volume) {
    const glm::dvec3 half = half_of(volume);
    Affine result = map;
    for (int i = 0; i < 3; ++i) result.linear[i] /= half;
    result.translation = (map.translation - volume.center) / half;
    return result;
}

/// From the unit coordinates of a volume.
Affine from_unit(const CompiledVolume& volume) {
    const glm::dvec3 half = half_of(volume);
    return {glm::dmat3{half.x, 0, 0, 0, half.y, 0, 0, 0, half.z}, volume.center};
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

WideSet make_set(const CompiledShape& shape, const CompiledSet& set, int first_set) {
    WideSet wide;
    wide.count = static_cast<int>(set.maps.size());
    wide.stride = (wide.count + table_step - 1) / table_step * table_step;
    wide.polar = shape.lipschitz == kernels::Lipschitz::polar;
    wide.twice = LaneTable<double>(ChildField::count, wide.stride);
    wide.single = LaneTable<float>(ChildField::count, wide.stride);
    for (int lane = 0; lane < wide.count; ++lane) {
        const int symbol = set.maps[static_cast<std::size_t>(lane)];
        const CompiledMap& map = shape.maps[static_cast<std::size_t>(symbol)];
        const CompiledVolume& inner = shape.sets[static_cast<std::size_t>(map.follow_set)].volume;
        const Affine step = into_unit(then(from_unit(set.volume), inverse(map.map)), inner);
        write_child(wide.twice, lane, step, map, inner.diameter);
        write_child(wide.single, lane, step, map, inner.diameter);
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

bool mixed_volumes(const CompiledShape& shape) {
    return std::ranges::any_of(shape.sets, [&](const CompiledSet& set) {
        const auto kind = [&](int symbol) {
            const CompiledMap& map = shape.maps[static_cast<std::size_t>(symbol)];
            return shape.sets[static_cast<std::size_t>(map.follow_set)].volume.kind;
        };
        return std::ranges::any_of(set.maps,
                                   [&](int symbol) { return kind(symbol) != kind(set.maps[0]); });
    });
}

}  // namespace

std::string why_not_wide(const CompiledScene& scene, Numeric numeric) {
    if (numeric == Numeric::twice) return "the numbers are double, and the wide engine's are float";
    if (numeric == Numeric::dsp32) return "the numbers are dsp32, and the wide engine's are float";
    for (const CompiledObject& object : scene.objects) {
        const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
        if (shape.lifted) {
            return fmt::format("object \"{}\" has singular maps, which were lifted", object.name);
        }
        if (mixed_volumes(shape)) {
            return fmt::format("object \"{}\" has balls and boxes side by side", object.name);
        }
        if (shape.maps.size() > most_maps) {
            return fmt::format("object \"{}\" has more than {} maps", object.name, most_maps);
        }
    }
    return "";
}

WideScene make_wide_scene(const CompiledScene& scene) {
    WideScene wide;
    wide.camera = scene.camera;
    wide.detail = scene.detail;
    wide.cell_cap = scene.cell_cap;
    wide.unit = scene.unit;
    wide.shading = scene.shading;
    wide.ambient = floats(scene.ambient);
    wide.background = floats(scene.background);
    wide.lights = scene.lights;
    std::vector<int> first_sets;
    for (const CompiledShape& shape : scene.shapes) {
        first_sets.push_back(static_cast<int>(wide.sets.size()));
        for (const CompiledSet& set : shape.sets) {
            wide.sets.push_back(make_set(shape, set, first_sets.back()));
        }
    }
    for (const CompiledObject& object : scene.objects) {
        const auto index = static_cast<std::size_t>(object.shape);
        const CompiledShape& shape = scene.shapes[index];
        const CompiledVolume& volume = shape.sets[static_cast<std::size_t>(shape.start)].volume;
        WideObject result;
        result.to_unit = into_unit(inverse(object.instance), volume);
        result.linear = object.instance.linear;
        result.set = first_sets[index] + shape.start;
        result.spheres = volume.kind == kernels::Volume::sphere;
        result.constant = object.constant;
        result.diameter = volume.diameter;
        result.smallest_pixel = smallest_pixel_share<double>() * object.diameter;
        result.levels = object.levels;
        result.one_kind = std::ranges::all_of(
            shape.sets, [&](const CompiledSet& set) { return set.volume.kind == volume.kind; });
        result.colored =
            std::ranges::any_of(shape.maps, [](const CompiledMap& map) { return map.color.a > 0; });
        result.color = floats(object.color);
        result.diffuse = static_cast<float>(object.diffuse);
        result.center = object.instance.point(volume.center);
        result.radius = lipschitz_constant(object.instance) * half_of(volume).x;
        result.fixed_direction = has_fixed_direction(scene, object);
        wide.objects.push_back(result);
    }
    tabulate_homotheties(wide);
    return wide;
}

}  // namespace pxm::host::wide
