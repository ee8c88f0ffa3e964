#include "host/wide/packet/ray_packet.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace pxm::host::wide {

namespace {

glm::dvec3 in_frame(const RayPacket& packet, const glm::dvec3& v) {
    return {glm::dot(v, packet.axis[0]), glm::dot(v, packet.axis[1]), glm::dot(v, packet.axis[2])};
}

/// A point of the picture's plane, in pixels from the tile's first ray.
glm::dvec3 on_plane(const RayPacket& packet, double column, double row) {
    return packet.fan.first + packet.fan.per_column * column + packet.fan.per_row * row;
}

/// Where a ray is beside the axis: at a depth of 1, or everywhere.
glm::dvec2 beside_axis(const RayPacket& packet, const glm::dvec3& p) {
    return packet.perspective ? glm::dvec2{p.x / p.z, p.y / p.z} : glm::dvec2{p.x, p.y};
}

std::uint64_t pixels_inside(const CropWindow& window, long left, long top) {
    const bool whole = window.x0 <= left && left + tile_side <= window.x1 && window.y0 <= top &&
                       top + tile_side <= window.y1;
    if (whole) return ~std::uint64_t{0};
    std::uint64_t inside = 0;
    for (int ray = 0; ray < packet_rays; ++ray) {
        const long x = left + ray % tile_side;
        const long y = top + ray / tile_side;
        if (window.x0 <= x && x < window.x1 && window.y0 <= y && y < window.y1) {
            inside |= std::uint64_t{1} << ray;
        }
    }
    return inside;
}

/// What lies between four corners is nowhere farther from the axis than they are.
void reach_corners(RayPacket& packet) {
    constexpr double last = tile_side - 1;
    glm::dvec2 farthest{0, 0};
    for (const double row : {0.0, last}) {
        for (const double column : {0.0, last}) {
            farthest =
                glm::max(farthest, glm::abs(beside_axis(packet, on_plane(packet, column, row))));
        }
    }
    const glm::dvec2 none{0, 0};
    const glm::dvec2 constant = packet.perspective ? none : farthest;
    const glm::dvec2 growing = packet.perspective ? farthest : none;
    packet.reach_u0 = constant.x;
    packet.reach_v0 = constant.y;
    packet.reach_u1 = growing.x;
    packet.reach_v1 = growing.y;
    packet.most_at_origin = packet.pixel_at_origin;
    packet.most_growth = packet.pixel_growth * std::sqrt(1 + glm::dot(growing, growing));
}

}  // namespace

void aim_at_tile(RayPacket& packet, const CompiledCamera& camera, const CropWindow& window,
                 const TileCorner& tile, const glm::dvec2& place) {
    constexpr double half = tile_side / 2.0;
    const auto& [left, top] = tile;
    const auto at = [&](double column, double row) {
        return camera.corner + camera.across * (static_cast<double>(tile.left) + column) +
               camera.down * (static_cast<double>(tile.top) + row);
    };
    packet.perspective = camera.projection == kernels::Projection::perspective;
    packet.origin = glm::dvec3{0.0};
    packet.axis[2] = glm::normalize(packet.perspective ? at(half, half) : camera.forward);
    packet.axis[0] =
        glm::normalize(camera.across - packet.axis[2] * glm::dot(camera.across, packet.axis[2]));
    packet.axis[1] = glm::cross(packet.axis[2], packet.axis[0]);
    packet.fan = {in_frame(packet, at(place.x, place.y)), in_frame(packet, camera.across),
                  in_frame(packet, camera.down)};
    packet.is_spread = false;
    packet.any_hit = false;
    packet.candidate_view = {CandidateViewOf::Kind::eye, left, top};
    packet.pixel_at_origin = camera.pixel_at_eye;
    packet.pixel_growth = camera.pixel_growth;
    packet.inside = pixels_inside(window, left, top);
    packet.end.fill(std::numeric_limits<double>::infinity());
    reach_corners(packet);
}

bool go_together(const LoneRay& a, const LoneRay& b) {
    constexpr double least_cosine = 0.9999;
    constexpr double most_pixels = 2 * tile_side;  // apart, where they begin
    if (glm::dot(a.direction, b.direction) < least_cosine) return false;
    const glm::dvec3 apart = b.origin + b.start * b.direction - a.origin - a.start * a.direction;
    const double pixel = a.pixel_at_origin + a.pixel_growth * a.start;
    const double room = most_pixels * pixel;
    if (glm::dot(apart, apart) > room * room) return false;
    if (!std::isfinite(a.end) || !std::isfinite(b.end)) return true;
    const double last = most_pixels * (a.pixel_at_origin + a.pixel_growth * a.end);
    const glm::dvec3 apart_at_end = b.origin + b.end * b.direction - a.origin - a.end * a.direction;
    return glm::dot(apart_at_end, apart_at_end) <= last * last;
}

namespace {

/// Fills in a lane of a packet whose frame is known, and widens what the packet reaches.
void put_ray(RayPacket& packet, std::size_t i, const LoneRay& ray) {
    const glm::dvec3 o = in_frame(packet, ray.origin - packet.origin);
    const glm::dvec3 d = in_frame(packet, ray.direction);
    const glm::dvec2 beside1{d.x / d.z, d.y / d.z};
    const glm::dvec2 beside0{o.x - o.z * beside1.x, o.y - o.z * beside1.y};
    const double length = 1 / d.z;  // t = (z - o.z) length
    const double pixel1 = ray.pixel_growth * length;
    const double pixel0 = ray.pixel_at_origin - o.z * pixel1;
    packet.u0[i] = static_cast<float>(beside0.x);
    packet.v0[i] = static_cast<float>(beside0.y);
    packet.u1[i] = static_cast<float>(beside1.x);
    packet.v1[i] = static_cast<float>(beside1.y);
    packet.stretch[i] = static_cast<float>(length);
    packet.shrink2[i] = static_cast<float>(d.z * d.z);
    packet.start[i] = static_cast<float>(std::max(0.0, o.z + ray.start * d.z));
    packet.pixel0[i] = static_cast<float>(pixel0);
    packet.pixel1[i] = static_cast<float>(pixel1);
    packet.end[i] = o.z + ray.end * d.z;
    packet.inside |= std::uint64_t{1} << i;
    packet.reach_u0 = std::max(packet.reach_u0, std::abs(beside0.x));
    packet.reach_v0 = std::max(packet.reach_v0, std::abs(beside0.y));
    packet.reach_u1 = std::max(packet.reach_u1, std::abs(beside1.x));
    packet.reach_v1 = std::max(packet.reach_v1, std::abs(beside1.y));
    packet.pixel_at_origin = std::min(packet.pixel_at_origin, pixel0);
    packet.pixel_growth = std::min(packet.pixel_growth, pixel1);
    packet.most_at_origin = std::max(packet.most_at_origin, pixel0);
    packet.most_growth = std::max(packet.most_growth, pixel1);
}

}  // namespace

void gather_rays(RayPacket& packet, std::span<const LoneRay> rays) {
    const auto count = static_cast<double>(rays.size());
    glm::dvec3 way{0.0}, middle{0.0};
    for (const LoneRay& ray : rays) {
        way += ray.direction;
        middle += (ray.origin + ray.start * ray.direction) / count;
    }
    const glm::dvec3 w = glm::normalize(way);
    const glm::dvec3 other = std::abs(w.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    packet.axis[2] = w;
    packet.axis[0] = glm::normalize(glm::cross(other, w));
    packet.axis[1] = glm::cross(w, packet.axis[0]);
    packet.perspective = false;
    packet.is_spread = true;
    packet.candidate_view = {};
    double behind = 0;
    for (const LoneRay& ray : rays) {
        const glm::dvec3 begin = ray.origin + ray.start * ray.direction - middle;
        behind = std::min(behind, glm::dot(begin, w));
    }
    packet.origin = middle + behind * w;
    packet.reach_u0 = packet.reach_u1 = packet.reach_v0 = packet.reach_v1 = 0;
    packet.pixel_at_origin = packet.pixel_growth = std::numeric_limits<double>::infinity();
    packet.most_at_origin = packet.most_growth = -std::numeric_limits<double>::infinity();
    packet.inside = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) put_ray(packet, i, rays[i]);
    for (std::size_t i = rays.size(); i < packet_rays; ++i) {  // numbers that do no harm
        for (float* lane : {packet.u0, packet.v0, packet.u1, packet.v1, packet.start, packet.pixel0,
                            packet.pixel1}) {
            lane[i] = 0;
        }
        packet.stretch[i] = packet.shrink2[i] = 1;
    }
}

}  // namespace pxm::host::wide
