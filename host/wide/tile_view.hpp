// The 64 rays of an 8x8 tile in coordinates of their own: the z axis W looks through the tile's
// middle, and a ray is where it is beside that axis at a depth z. In these numbers a narrow tile is
// narrow, however far away or magnified: what its rays share is kept in double, what sets them
// apart fits a float.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "host/render/compiled_scene.hpp"

namespace pxm::host::wide {

inline constexpr int tile_side = 8;
inline constexpr int tile_rays = tile_side * tile_side;

/// The points (u0 + u1 z, v0 + v1 z, z) of the tile's frame; a ray's parameter t is stretch * z.
struct TileView {
    glm::dvec3 axis[3];   // U, V, W: unit vectors in scene units, perpendicular
    double reach_u0 = 0;  // |u0| of all rays is at most so much, and so on
    double reach_u1 = 0;
    double reach_v0 = 0;
    double reach_v1 = 0;
    alignas(64) float u0[tile_rays];
    alignas(64) float u1[tile_rays];
    alignas(64) float v0[tile_rays];
    alignas(64) float v1[tile_rays];
    alignas(64) float stretch[tile_rays];
    alignas(64) float shrink2[tile_rays];  // 1 / stretch^2
    std::uint64_t inside = 0;  // rays whose pixel is to be rendered, bit 8 * row + column
};

/// The tile whose first pixel is (left, top); `window` says which pixels are wanted.
[[nodiscard]] TileView make_tile_view(const CompiledCamera& camera, const CropWindow& window,
                                      long left, long top);

}  // namespace pxm::host::wide
