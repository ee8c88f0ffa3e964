#include "host/node_program/steepness.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host/math/lipschitz.hpp"
#include "host/node_program/write_scene_block.hpp"

namespace pxm::host {

namespace {

constexpr double longest = 60;  // binary digits of a length whose square is in range

/// How many binary digits longer the inverse makes a direction at most, along axes that the map has
/// not lost.
double stretch(const CompiledMap& map) {
    const std::size_t axes = 3 - std::min<std::size_t>(map.lost.size(), 2);
    return -std::log2(singular_values(map.map.linear).values[axes - 1]);
}

/// How many binary digits larger an object is than a pixel where it is nearest to the eye.
double digits_of_size(const CompiledScene& scene, const CompiledObject& object) {
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
    const CompiledVolume& volume = shape.sets[static_cast<std::size_t>(object.start)].volume;
    const double distance = glm::length(object.instance.point(volume.center));
    const double nearest = std::max(0.0, distance - object.diameter / 2);
    const double pixel = scene.camera.pixel_at_eye + scene.camera.pixel_growth * nearest;
    const double smallest = smallest_pixel_share<float>() * object.diameter;
    return std::log2(object.diameter / std::max(scene.detail * pixel, smallest));
}

/// Whether a map squashes so much in one direction that its inverse has to be taken apart.
bool squashes(const CompiledMap& map) {
    const std::size_t axes = 3 - std::min<std::size_t>(map.lost.size(), 2);
    const auto values = singular_values(map.map.linear).values;
    return values[0] > least_steep * values[axes - 1];
}

bool is_steep(const CompiledScene& scene, const CompiledObject& object) {
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
    // Directions are long in small cells too, at any zoom: there all lengths are.
    if (std::ranges::none_of(shape.maps, squashes)) return false;
    double most = 0;   // digits that a map adds
    double share = 0;  // the same for each digit that the map makes cells smaller
    for (const CompiledMap& map : shape.maps) {
        most = std::max(most, stretch(map));
        const double smaller = -std::log2(map.constant);
        share = smaller > 0 ? std::max(share, stretch(map) / smaller)
                            : std::numeric_limits<double>::infinity();
    }
    // Cells are opened that are larger than a pixel, and the last ones are those inside them.
    const double by_size = share * std::max(0.0, digits_of_size(scene, object)) + most;
    const double by_levels = most * static_cast<double>(object.levels);
    const double outermost = -std::log2(smallest_singular_value(object.instance));
    return outermost + std::min(by_size, by_levels) > longest;
}

}  // namespace

std::vector<bool> steep_shapes(const CompiledScene& scene) {
    std::vector<bool> steep(scene.shapes.size(), false);
    for (const CompiledObject& object : scene.objects) {
        const auto shape = static_cast<std::size_t>(object.shape);
        if (is_steep(scene, object)) steep[shape] = true;
    }
    return steep;
}

}  // namespace pxm::host
