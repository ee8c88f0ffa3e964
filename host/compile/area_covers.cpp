#include "host/compile/area_covers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <random>
#include <vector>

#include "dsp_kernels/beam_cell.hpp"
#include "host/compile/samples.hpp"
#include "host/compile/trial.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr double detail_of_beams = 0.7;    // of a pixel: docs/measurements/local-covers.md
constexpr long places_in_beam = 12;        // where the scene does not say
constexpr std::size_t measured_sets = 64;  // of a shape; others are taken to be like the first

bool all_maps_are(const CompiledShape& shape, MapKind most) {
    return std::ranges::all_of(shape.maps,
                               [&](const CompiledMap& map) { return classify(map.map) <= most; });
}

/// The eye's ray to an object.
glm::dvec3 way_to(const CompiledScene& scene, const CompiledObject& object) {
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
    const CompiledSet& set = shape.sets[static_cast<std::size_t>(shape.start)];
    return scene.camera.projection == kernels::Projection::orthographic
               ? scene.camera.forward
               : object.instance.point(set.volume.center);
}

/// A place of a cell of `set` that is as small as those of the picture, if words of a pleasant
/// length lead to one.
std::optional<Affine> place_of_small_cell(const CompiledScene& scene, const CompiledObject& object,
                                          int set, std::mt19937& random) {
    constexpr int longest = 80;
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
    const double away = glm::length(object.instance.translation);
    const double pixel = scene.camera.pixel_at_eye + scene.camera.pixel_growth * away;
    Affine place = object.instance;
    int at = object.start;
    for (int level = 0; level < longest; ++level) {
        const CompiledSet& here = shape.sets[static_cast<std::size_t>(at)];
        const double diameter = lipschitz_constant(place) * here.volume.diameter;
        if (at == set && diameter <= scene.detail * pixel) return place;
        const int map = here.maps[random() % here.maps.size()];
        const CompiledMap& next = shape.maps[static_cast<std::size_t>(map)];
        place = then(next.map, place);
        at = next.follow_set;
    }
    return std::nullopt;
}

/// Where small cells of a set are seen from, in their own coordinates. Maps that squash make them
/// look like nothing that is larger: what is flat is seen from above.
std::vector<glm::dvec3> views_of_small_cells(const CompiledScene& scene, std::size_t shape,
                                             std::size_t set) {
    constexpr int views_of_object = 12;
    std::vector<glm::dvec3> views;
    std::mt19937 random(1);
    for (const CompiledObject& object : scene.objects) {
        if (static_cast<std::size_t>(object.shape) != shape) continue;
        const glm::dvec3 along = way_to(scene, object);
        for (int i = 0; i < views_of_object; ++i) {
            const auto place = place_of_small_cell(scene, object, static_cast<int>(set), random);
            if (place) views.push_back(glm::normalize(inverse(*place).direction(along)));
        }
    }
    return views;
}

/// Where a shape's cells are seen from, in its own coordinates: along the eye's rays to its objects
/// and a little beside them. Nothing if its maps turn the cells this way and that.
std::vector<glm::dvec3> views_of(const CompiledScene& scene, std::size_t shape, std::size_t set) {
    constexpr double beside = 0.1;
    std::vector<glm::dvec3> views;
    const CompiledShape& seen = scene.shapes[shape];
    if (!all_maps_are(seen, MapKind::homothety)) {
        const bool squashed = !all_maps_are(seen, MapKind::similitude) && !seen.lifted;
        return squashed ? views_of_small_cells(scene, shape, set) : views;
    }
    for (const CompiledObject& object : scene.objects) {
        if (static_cast<std::size_t>(object.shape) != shape) continue;
        const glm::dvec3 view =
            glm::normalize(inverse(object.instance).direction(way_to(scene, object)));
        for (const glm::dvec3& aside :
             {glm::dvec3{0.9, 0.3, -0.3}, glm::dvec3{-0.2, -1, 0.3}, glm::dvec3{-0.6, 0.5, 0.8}}) {
            views.push_back(view + beside * aside);
        }
    }
    return views;
}

void measure_coverage(CompiledScene& scene, std::size_t index) {
    CompiledShape& shape = scene.shapes[index];
    if (shape.maps.empty()) return;
    const auto measured = [&](std::size_t set) {
        return mean_coverage(shape, set, views_of(scene, index, set));
    };
    const auto start = static_cast<std::size_t>(shape.start);
    shape.sets[start].coverage = measured(start);
    for (std::size_t set = 0; set < shape.sets.size(); ++set) {
        if (set == start) continue;
        shape.sets[set].coverage = set < measured_sets ? measured(set) : shape.sets[start].coverage;
    }
}

}  // namespace

void cover_by_area(const RenderBlock& render, const std::vector<bool>& filled, CompiledScene& scene,
                   Diagnostics& diagnostics) {
    const long places = render.samples.value_or(places_in_beam);
    if (places > kernels::most_places) {
        diagnostics.error(render.covers_position,
                          fmt::format("covers: area asks for at most {} places in a pixel, and "
                                      "'samples' is {}",
                                      kernels::most_places, places));
        return;
    }
    if (std::ranges::any_of(scene.objects, [](const auto& object) { return object.opacity < 1; })) {
        diagnostics.error(render.covers_position,
                          "covers: area takes no translucent objects; covers: on does");
        return;
    }
    scene.covers = true;
    scene.area = true;
    scene.detail *= detail_of_beams;
    scene.fade = scene.detail;
    scene.samples = sample_places(places);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        // What is filled leaves nothing free inside, however far its volumes stand out of it.
        if (!filled[i]) measure_coverage(scene, i);
    }
}

}  // namespace pxm::host
