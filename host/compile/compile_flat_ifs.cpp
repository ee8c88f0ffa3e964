#include "host/compile/compile_flat_ifs.hpp"

#include <algorithm>
#include <cmath>

namespace pxm::host {

namespace {

constexpr double thinnest = 1e-6;  // side of a box, as a share of the longer one
constexpr double leak = 1e-12;     // of z into x or y: rotations are not exact

/// The system without its z; false if z takes part in x or y.
bool flatten(Rifs& rifs) {
    for (Affine& map : rifs.maps) {
        const glm::dvec3& of_z = map.linear[2];
        if (std::max(std::abs(of_z.x), std::abs(of_z.y)) > leak) return false;
        map.linear[2] = glm::dvec3{0.0};
        map.linear[0].z = map.linear[1].z = map.translation.z = 0;
    }
    return true;
}

}  // namespace

glm::dvec2 compile_flat_ifs(const Fractal& fractal, CompiledTexture& texture) {
    Rifs rifs = fractal.exact;
    if (!flatten(rifs)) return {0.0, 0.0};
    const std::vector<Bounds> bounds = bound(rifs, fractal.contraction);
    const Box& box = bounds[static_cast<std::size_t>(rifs.start)].box;
    const glm::dvec2 low{box.low};
    glm::dvec2 size = glm::dvec2{box.high} - low;
    double unit = std::max(size.x, size.y);
    if (!(unit > 0)) unit = 1;
    const glm::dvec2 extent = size / unit;
    size = {std::max(extent.x, thinnest) * unit, std::max(extent.y, thinnest) * unit};
    const auto place = [&](const glm::dvec3& x) { return (glm::dvec2{x} - low) / unit; };
    for (std::size_t i = 0; i < rifs.maps.size(); ++i) {
        const Affine& map = rifs.maps[i];
        texture.maps.push_back({{glm::dvec2{map.linear[0]}, glm::dvec2{map.linear[1]}},
                                place(map.point({low.x, low.y, 0})),
                                rifs.follow_of[i]});
    }
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        texture.sets.push_back(
            {place(bounds[s].ball.center), bounds[s].ball.radius / unit, rifs.follow_sets[s].maps});
    }
    texture.start = rifs.start;
    texture.step = unit / size;
    texture.corner = (1.0 - extent * texture.step) / 2.0;  // a line lies in the middle
    return size;
}

}  // namespace pxm::host
