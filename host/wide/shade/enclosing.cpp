#include "host/wide/shade/enclosing.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace pxm::host::wide {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Where a line enters a volume, and the outward normal there, of any length.
struct Entry {
    double depth = -never;
    glm::dvec3 normal{0.0};
    double exit = never;

    /// Clips to the points with normal . x <= offset.
    void clip(const glm::dvec3& o, const glm::dvec3& d, const glm::dvec3& face, double offset) {
        const double slope = glm::dot(face, d);
        const double at = (offset - glm::dot(face, o)) / slope;
        if (slope > 0) exit = std::min(exit, at);
        if (slope < 0 && depth < at) {
            depth = at;
            normal = face;
        }
    }
};

Entry enter_ball(const CompiledVolume& ball, const glm::dvec3& o, const glm::dvec3& d) {
    Entry entry;
    const glm::dvec3 to_center = ball.center - o;
    const double beyond = glm::dot(to_center, to_center) - ball.radius * ball.radius;
    const double along = glm::dot(to_center, d);
    const double chord2 = along * along - glm::dot(d, d) * beyond;
    if (!(chord2 > 0 && along > 0 && beyond > 0)) return entry;
    entry.depth = beyond / (along + std::sqrt(chord2));
    entry.normal = entry.depth * d - to_center;
    return entry;
}

Entry enter(const CompiledVolume& volume, const glm::dvec3& o, const glm::dvec3& d) {
    if (volume.kind == kernels::Volume::sphere) return enter_ball(volume, o, d);
    Entry entry;
    for (const HalfSpace& side : volume.half_spaces) entry.clip(o, d, side.normal, side.offset);
    if (volume.kind == kernels::Volume::box) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 face{0};
            face[axis] = 1;
            entry.clip(o, d, face, volume.high[axis]);
            entry.clip(o, d, -face, -volume.low[axis]);
        }
    }
    return entry;
}

}  // namespace

void find_enclosing(const WideScene& scene, const WideObject& object, const RayPacket& packet,
                    int ray, std::vector<EnclosingNormal>& found) {
    found.clear();
    if (object.enclosing < 0) return;
    const glm::dmat3 frame{packet.axis[0], packet.axis[1], packet.axis[2]};
    const glm::dvec3 origin = packet.origin + frame * glm::dvec3{packet.u0[ray], packet.v0[ray], 0};
    const glm::dvec3 direction = frame * glm::dvec3{packet.u1[ray], packet.v1[ray], 1};
    for (int at = object.enclosing; at >= 0;) {
        const CompiledEnclosure& cell = scene.enclosures[static_cast<std::size_t>(at)];
        const Entry entry =
            enter(cell.volume, cell.inverse.point(origin), cell.inverse.direction(direction));
        at = cell.enclosing;
        if (!(static_cast<double>(packet.start[ray]) < entry.depth && entry.depth <= entry.exit)) {
            continue;
        }
        // Normals go through the transpose of the inverse, and then into the packet's frame.
        const glm::dvec3 normal = glm::normalize(entry.normal * cell.inverse.linear);
        found.push_back(
            {glm::vec3{normal * frame}, entry.depth, static_cast<float>(cell.volume.diameter)});
    }
}

}  // namespace pxm::host::wide
