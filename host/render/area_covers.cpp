#include "host/render/area_covers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "dsp_kernels/beam_cell.hpp"
#include "host/fractal/lipschitz.hpp"
#include "host/render/samples.hpp"
#include "host/render/trial.hpp"

namespace pxm::host {

namespace {

constexpr double detail_of_beams = 0.7;    // of a pixel: measured, as docs/performance.md says
constexpr long places_in_beam = 12;        // where the scene does not say
constexpr std::size_t measured_sets = 64;  // of a shape; others are taken to be like the first

/// Where a shape's cells are seen from, in its own coordinates: along the eye's rays to its objects
/// and a little beside them. Nothing if its maps turn the cells this way and that.
std::vector<glm::dvec3> views_of(const CompiledScene& scene, std::size_t shape) {
    constexpr double beside = 0.1;
    std::vector<glm::dvec3> views;
    if (!std::ranges::all_of(scene.shapes[shape].maps, [](const CompiledMap& map) {
            return classify(map.map) == MapKind::homothety;
        })) {
        return views;
    }
    const CompiledShape& seen = scene.shapes[shape];
    for (const CompiledObject& object : scene.objects) {
        if (static_cast<std::size_t>(object.shape) != shape) continue;
        const auto start = static_cast<std::size_t>(seen.start);
        const glm::dvec3 along = scene.camera.projection == kernels::Projection::orthographic
                                     ? scene.camera.forward
                                     : object.instance.point(seen.sets[start].volume.center);
        const glm::dvec3 view = glm::normalize(inverse(object.instance).direction(along));
        for (const glm::dvec3& aside :
             {glm::dvec3{0.9, 0.3, -0.3}, glm::dvec3{-0.2, -1, 0.3}, glm::dvec3{-0.6, 0.5, 0.8}}) {
            views.push_back(view + beside * aside);
        }
    }
    return views;
}

void measure_coverage(CompiledShape& shape, const std::vector<glm::dvec3>& views) {
    if (shape.maps.empty()) return;
    const auto start = static_cast<std::size_t>(shape.start);
    shape.sets[start].coverage = mean_coverage(shape, start, views);
    for (std::size_t set = 0; set < shape.sets.size(); ++set) {
        if (set == start) continue;
        shape.sets[set].coverage =
            set < measured_sets ? mean_coverage(shape, set, views) : shape.sets[start].coverage;
    }
}

}  // namespace

void cover_by_area(const RenderBlock& render, CompiledScene& scene, Diagnostics& diagnostics) {
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
        measure_coverage(scene.shapes[i], views_of(scene, i));
    }
}

}  // namespace pxm::host
