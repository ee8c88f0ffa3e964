#include "host/wide/tables/eligible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "host/math/lipschitz.hpp"
#include "host/wide/tables/homothety_tables.hpp"
#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

namespace {

/// Whether a volume is a ball or a box, in whatever axes, that is not flat.
bool is_ball_or_box(const CompiledVolume& volume) {
    if (volume.kind == kernels::Volume::oriented) {
        return std::ranges::all_of(volume.half, [&](const glm::dvec3& half) {
            return glm::length(half) > thinnest * volume.diameter;
        });
    }
    return volume.kind == kernels::Volume::sphere || volume.kind == kernels::Volume::box;
}

bool has_balls(const CompiledSet& set) { return set.volume.kind == kernels::Volume::sphere; }

/// Grass and its kin: children tested together, without the culls in between, are hundreds of times
/// more cells there, and a render does not end in comfortable time.
bool squashes_much(const Affine& map) {
    constexpr double much = 16;  // times more in one direction than in another
    const auto values = singular_values(map.linear).values;
    return !(values[0] <= much * values[2]);
}

/// Cells that hardly get smaller from level to level would fill the tables that a tile's rays
/// share: gigabytes at 0.995.
bool hardly_contracts(const CompiledMap& map) { return !(map.constant <= 0.985); }

std::string why_not(const CompiledScene& scene, const CompiledObject& object) {
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
    if (shape.lifted) return "has singular maps, which were lifted";
    // One search for all cells of a tile has no account of those that are alike.
    if (shape.crowded && !scene.area) return "has cells that overlap very much";
    if (!std::ranges::all_of(shape.sets, is_ball_or_box, &CompiledSet::volume)) {
        return "has bounding volumes that are neither balls nor boxes";
    }
    const auto balls = std::ranges::count_if(shape.sets, has_balls);
    if (balls != 0 && balls != std::ssize(shape.sets)) return "has balls and boxes side by side";
    if (shape.maps.size() > most_maps) return fmt::format("has more than {} maps", most_maps);
    if (std::ranges::any_of(shape.maps, squashes_much, &CompiledMap::map)) {
        return "has maps that squash very much";
    }
    if (!object.prefix.empty() && squashes_much(object.instance)) {
        return "has cells near the eye that are squashed very much";
    }
    if (std::ranges::any_of(shape.maps, hardly_contracts)) return "has maps that hardly contract";
    return "";
}

ObjectMethod wide_method(const CompiledScene& scene, const CompiledObject& object,
                         const WideObject& wide, const std::vector<WideSet>& sets) {
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
    if (scene.area) return {object.name, "wide, beams", "local covers by area"};
    if (!wide.of_homotheties) {
        const bool many = shape.maps.size() > static_cast<std::size_t>(opened_cell_room);
        return {object.name, "wide, composed maps",
                is_of_homotheties(scene, object) && many ? "very many maps"
                                                         : "maps that are no homotheties"};
    }
    if (wide.grid) return {object.name, "wide, grid walk", "homotheties to boxes in slices"};
    const std::vector<HomothetyTable>& composed = sets[static_cast<std::size_t>(wide.set)].composed;
    if (!composed.empty()) {
        const std::string levels =
            fmt::format("homotheties, up to {} levels at once", composed.back().steps);
        const bool lists = composed.back().count > table_step;
        return {object.name, lists ? "wide, listed cells" : "wide, grandchildren", levels};
    }
    return {object.name, "wide, children", "homotheties"};
}

/// Why none of the objects is rendered by the wide engine, given why not each of them.
std::string why_not_any(const CompiledScene& scene, const std::vector<std::string>& why_not) {
    if (needs_covers(scene) && !scene.area) {
        return "local covers by diameter and translucent objects are the reference kernels'";
    }
    if (scene.objects.empty()) return "there is no object";
    for (std::size_t i = 0; i < why_not.size(); ++i) {
        if (scene.area && !why_not[i].empty()) {  // the cells of all objects share a pixel's places
            return fmt::format("object \"{}\" {}, and local covers by area are done by one engine",
                               scene.objects[i].name, why_not[i]);
        }
    }
    const auto first = std::ranges::find(why_not, "");
    if (first != why_not.end()) return "";
    return fmt::format("object \"{}\" {}", scene.objects.front().name, why_not.front());
}

}  // namespace

std::vector<std::string> why_not_objects(const CompiledScene& scene) {
    std::vector<std::string> reasons;
    for (const CompiledObject& object : scene.objects) reasons.push_back(why_not(scene, object));
    return reasons;
}

std::string why_not_wide(const CompiledScene& scene, Numeric numeric) {
    if (numeric == Numeric::double_)
        return "the numbers are double, and the wide engine's are float";
    if (numeric == Numeric::dsp32) return "the numbers are dsp32, and the wide engine's are float";
    return why_not_any(scene, why_not_objects(scene));
}

std::vector<ObjectMethod> object_methods(const CompiledScene& scene) {
    std::vector<std::string> why_not = why_not_objects(scene);
    const std::string reason = why_not_any(scene, why_not);
    const WideScene wide = reason.empty() ? make_wide_scene(scene) : WideScene{};
    std::vector<ObjectMethod> methods;
    std::size_t next = 0;  // of the wide scene's objects
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const CompiledObject& object = scene.objects[i];
        const bool eligible = why_not[i].empty();
        const std::size_t at = eligible ? next++ : 0;
        if (object.origin < static_cast<int>(methods.size())) continue;
        if (!reason.empty() || !eligible) {
            methods.push_back({object.name, "heap", eligible ? reason : "it " + why_not[i]});
        } else {
            methods.push_back(wide_method(scene, object, wide.objects[at], wide.sets));
        }
    }
    return methods;
}

}  // namespace pxm::host::wide
