#include "host/wide/tile_view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace pxm::host::wide {

namespace {

/// A vector that grows by steps in x and y, in the tile's frame.
struct Fan {
    glm::dvec3 first;
    glm::dvec3 per_column;
    glm::dvec3 per_row;
};

glm::dvec3 in_frame(const TileView& tile, const glm::dvec3& v) {
    return {glm::dot(v, tile.axis[0]), glm::dot(v, tile.axis[1]), glm::dot(v, tile.axis[2])};
}

void set_rays(TileView& tile, const Fan& fan, bool perspective) {
    for (int row = 0; row < tile_side; ++row) {
        for (int column = 0; column < tile_side; ++column) {
            const glm::dvec3 p = fan.first + fan.per_column * static_cast<double>(column) +
                                 fan.per_row * static_cast<double>(row);
            const int ray = row * tile_side + column;
            const double u = perspective ? p.x / p.z : p.x;
            const double v = perspective ? p.y / p.z : p.y;
            tile.u0[ray] = perspective ? 0.0F : static_cast<float>(u);
            tile.v0[ray] = perspective ? 0.0F : static_cast<float>(v);
            tile.u1[ray] = perspective ? static_cast<float>(u) : 0.0F;
            tile.v1[ray] = perspective ? static_cast<float>(v) : 0.0F;
            tile.stretch[ray] =
                perspective ? static_cast<float>(std::sqrt(1 + u * u + v * v)) : 1.0F;
            tile.shrink2[ray] = perspective ? static_cast<float>(1 / (1 + u * u + v * v)) : 1.0F;
            double& reach_u = perspective ? tile.reach_u1 : tile.reach_u0;
            double& reach_v = perspective ? tile.reach_v1 : tile.reach_v0;
            reach_u = std::max(reach_u, std::abs(u));
            reach_v = std::max(reach_v, std::abs(v));
        }
    }
}

std::uint64_t rays_inside(const CropWindow& window, long left, long top) {
    std::uint64_t inside = 0;
    for (int ray = 0; ray < tile_rays; ++ray) {
        const long x = left + ray % tile_side;
        const long y = top + ray / tile_side;
        if (window.x0 <= x && x < window.x1 && window.y0 <= y && y < window.y1) {
            inside |= std::uint64_t{1} << ray;
        }
    }
    return inside;
}

}  // namespace

TileView make_tile_view(const CompiledCamera& camera, const CropWindow& window, long left,
                        long top) {
    constexpr double half = tile_side / 2.0;
    TileView tile;
    const bool perspective = camera.projection == kernels::Projection::perspective;
    const glm::dvec3 middle = camera.corner + camera.across * (static_cast<double>(left) + half) +
                              camera.down * (static_cast<double>(top) + half);
    tile.axis[2] = glm::normalize(perspective ? middle : camera.forward);
    tile.axis[0] =
        glm::normalize(camera.across - tile.axis[2] * glm::dot(camera.across, tile.axis[2]));
    tile.axis[1] = glm::cross(tile.axis[2], tile.axis[0]);
    const glm::dvec3 first = camera.corner + camera.across * (static_cast<double>(left) + 0.5) +
                             camera.down * (static_cast<double>(top) + 0.5);
    const Fan fan{in_frame(tile, first), in_frame(tile, camera.across),
                  in_frame(tile, camera.down)};
    set_rays(tile, fan, perspective);
    tile.inside = rays_inside(window, left, top);
    return tile;
}

}  // namespace pxm::host::wide
