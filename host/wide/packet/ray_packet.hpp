// Up to 64 rays that go much the same way, in coordinates of their own: the z axis W looks along
// them, and a ray is where it is beside that axis at a depth z. In these numbers a narrow packet is
// narrow, however far away or magnified: what its rays share is kept in double, what sets them
// apart fits a float. The eye rays of an 8x8 tile are one, and so are the shadow rays of what they
// see.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "host/compiled/compiled_scene.hpp"
#include "host/engine/frame.hpp"

namespace pxm::host::wide {

inline constexpr int packet_rays = tile_side * tile_side;

/// Which view (host/wide/tables/candidate_views.hpp) the rays are seen in: one of their own, or
/// one that they share with others.
struct CandidateViewOf {
    enum class Kind { packet, eye, light };
    Kind kind = Kind::packet;
    long column = 0;  // of a tile's first pixel, or the light's number
    long row = 0;
};

/// The points origin + (u0 + u1 z, v0 + v1 z, z) of the packet's frame; the length along a ray is
/// stretch * z and more or less something. Lanes hold something only once the rays are spread
/// (host/wide/packet/packet_lanes.inl); most tiles see nothing and never need them.
struct RayPacket {
    glm::dvec3 origin{0.0};  // scene units
    glm::dvec3 axis[3];      // U, V, W: unit vectors in scene units, perpendicular
    double reach_u0 = 0;     // |u0| of all rays is at most so much, and so on
    double reach_u1 = 0;
    double reach_v0 = 0;
    double reach_v1 = 0;
    double pixel_at_origin = 0;  // p at depth z is at least pixel_at_origin + pixel_growth z
    double pixel_growth = 0;
    double most_at_origin = 0;  // and at most most_at_origin + most_growth z
    double most_growth = 0;
    std::uint64_t inside = 0;  // rays that are still wanted; of a tile, bit 8 * row + column
    CandidateViewOf candidate_view;
    bool any_hit = false;  // whether a ray meets something is all that is asked

    alignas(64) float u0[packet_rays];
    alignas(64) float u1[packet_rays];
    alignas(64) float v0[packet_rays];
    alignas(64) float v1[packet_rays];
    alignas(64) float stretch[packet_rays];
    alignas(64) float shrink2[packet_rays];  // 1 / stretch^2
    alignas(64) float start[packet_rays];    // the depth at which a ray begins, not below 0
    alignas(64) float pixel0[packet_rays];   // p at depth z is pixel0 + pixel1 z
    alignas(64) float pixel1[packet_rays];
    std::array<double, packet_rays> end;  // what is at this depth or beyond is not looked for

    struct Fan {  // points of the picture's plane in the packet's frame, from the eye
        glm::dvec3 first, per_column, per_row;
    } fan;
    bool perspective = true;
    bool is_spread = false;
};

/// The first pixel of a tile.
struct TileCorner {
    long left, top;
};

/// The eye rays of a tile, through `place` in the unit square of each pixel; `window` says which
/// pixels are wanted. Not spread yet.
void aim_at_tile(RayPacket& packet, const CompiledCamera& camera, const CropWindow& window,
                 const TileCorner& tile, const glm::dvec2& place);

/// A ray on its own, in scene units.
struct LoneRay {
    glm::dvec3 origin;
    glm::dvec3 direction;  // a unit vector
    double start;          // only cells between these two lengths are looked for
    double end;
    double pixel_at_origin;  // p(t) = pixel_at_origin + pixel_growth t
    double pixel_growth;
};

/// Whether two rays go so much the same way that they may be in one packet with the first.
[[nodiscard]] bool go_together(const LoneRay& a, const LoneRay& b);

/// The packet of at most packet_rays rays, each in the lane of its number.
/// Precondition: all go together with the first.
void gather_rays(RayPacket& packet, std::span<const LoneRay> rays);

}  // namespace pxm::host::wide
