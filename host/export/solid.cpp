#include "host/export/solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>

#include "dsp_kernels/scene_block.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {
namespace {

constexpr double square = 1e-9;  // columns are as good as perpendicular, or equally long

bool is_perpendicular(const glm::dmat3& m) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (std::abs(glm::dot(m[i], m[j])) > square * glm::length(m[i]) * glm::length(m[j]))
            return false;
    }
    return true;
}

bool is_round(const glm::dmat3& m) {
    const double length = glm::length(m[0]);
    return is_perpendicular(m) && std::abs(glm::length(m[1]) - length) <= square * length &&
           std::abs(glm::length(m[2]) - length) <= square * length;
}

/// Half edges of the boxes among the volumes.
std::optional<glm::dmat3> half_edges(const CompiledVolume& volume) {
    if (volume.kind == kernels::Volume::oriented)
        return glm::dmat3{volume.half[0], volume.half[1], volume.half[2]};
    if (volume.kind != kernels::Volume::box) return std::nullopt;
    const glm::dvec3 half = (volume.high - volume.low) / 2.0;
    return glm::dmat3{glm::dvec3{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}};
}

glm::dvec3 center_of(const CompiledVolume& volume) {
    return volume.kind == kernels::Volume::box ? (volume.low + volume.high) / 2.0 : volume.center;
}

double distance_to_edge(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& x) {
    const glm::dvec3 along = b - a;
    const double share = glm::dot(x - a, along) / glm::dot(along, along);
    return glm::distance(x, a + std::clamp(share, 0.0, 1.0) * along);
}

Box3 box_around(const std::vector<glm::dvec3>& points, const Affine& place) {
    Box3 box{glm::dvec3{std::numeric_limits<double>::infinity()},
             glm::dvec3{-std::numeric_limits<double>::infinity()}};
    for (const glm::dvec3& point : points) {
        box.low = glm::min(box.low, place.point(point));
        box.high = glm::max(box.high, place.point(point));
    }
    return box;
}

/// The image of the ball that has these half axes: how far it reaches along x is a row's length.
Box3 box_around_ball(const glm::dvec3& center, const glm::dmat3& axes, const Affine& place) {
    const glm::dmat3 rows = glm::transpose(place.linear * axes);
    const glm::dvec3 half{glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])};
    return {place.point(center) - half, place.point(center) + half};
}

solids::Ellipsoid ellipsoid(const glm::dvec3& center, const glm::dmat3& axes) {
    const glm::dmat3 back = glm::inverse(axes);
    return {center, axes, back, 1 / lipschitz_constant({back, glm::dvec3{0.0}})};
}

solids::Polytope polytope_of(const Mesh& mesh) {
    solids::Polytope polytope;
    polytope.corners = mesh.vertices;
    for (const auto& corners : mesh.faces) {
        solids::Face face;
        glm::dvec3 area{0.0};
        const glm::dvec3& first = mesh.vertices[corners[0]];
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec3& next = mesh.vertices[corners[(i + 1) % corners.size()]];
            face.corners.push_back(mesh.vertices[corners[i]]);
            area += glm::cross(face.corners.back() - first, next - first);
        }
        if (!(glm::length(area) > 0)) continue;
        face.normal = glm::normalize(area);
        face.offset = glm::dot(face.normal, first);
        polytope.faces.push_back(std::move(face));
    }
    return polytope;
}

double distance_to(const solids::Face& face, const glm::dvec3& x) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const glm::dvec3& a = face.corners[i];
        const glm::dvec3& b = face.corners[(i + 1) % face.corners.size()];
        if (a == b || glm::dot(glm::cross(face.normal, b - a), x - a) >= 0) continue;
        nearest = std::min(nearest, distance_to_edge(a, b, x));
    }
    const bool above = nearest == std::numeric_limits<double>::infinity();
    return above ? glm::dot(face.normal, x) - face.offset : nearest;
}

double distance_to(const solids::Polytope& polytope, const glm::dvec3& x, double reach) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const solids::Face& face : polytope.faces)
        farthest = std::max(farthest, glm::dot(face.normal, x) - face.offset);
    if (farthest <= 0 || farthest >= reach) return farthest;
    // What is nearest lies on a face that looks to the point.
    double nearest = std::numeric_limits<double>::infinity();
    for (const solids::Face& face : polytope.faces)
        if (glm::dot(face.normal, x) > face.offset)
            nearest = std::min(nearest, distance_to(face, x));
    return nearest;
}

}  // namespace

Solid::Solid(const CompiledVolume& volume, const Mesh& shape, const Affine& place) {
    if (volume.kind == kernels::Volume::sphere) {
        const glm::dvec3 center = place.point(volume.center);
        const glm::dmat3 axes = place.linear * volume.radius;
        if (is_round(axes))
            form_ = solids::Ball{center, glm::length(axes[0])};
        else
            form_ = ellipsoid(center, axes);
        return;
    }
    if (const auto half = half_edges(volume)) {
        const glm::dmat3 edges = place.linear * *half;
        if (is_perpendicular(edges)) {
            const glm::dvec3 lengths{glm::length(edges[0]), glm::length(edges[1]),
                                     glm::length(edges[2])};
            const glm::dmat3 axes{edges[0] / lengths.x, edges[1] / lengths.y, edges[2] / lengths.z};
            form_ = solids::Box{place.point(center_of(volume)), axes, lengths};
            return;
        }
    }
    form_ = polytope_of(image_of(shape, place));
}

double Solid::distance(const glm::dvec3& x, double reach) const {
    if (const auto* ball = std::get_if<solids::Ball>(&form_))
        return glm::distance(x, ball->center) - ball->radius;
    if (const auto* box = std::get_if<solids::Box>(&form_)) {
        const glm::dvec3 out = glm::abs((x - box->center) * box->axes) - box->half;
        const double inside = std::min(std::max({out.x, out.y, out.z}), 0.0);
        return glm::length(glm::max(out, glm::dvec3{0.0})) + inside;
    }
    if (const auto* ellipsoid = std::get_if<solids::Ellipsoid>(&form_)) {
        // Newton's step for |back x| = 1.
        const glm::dvec3 there = ellipsoid->back * (x - ellipsoid->center);
        const double far = glm::length(there);
        const double slope = glm::length(there * ellipsoid->back);
        return slope > 0 ? far * (far - 1) / slope : -ellipsoid->thinnest;
    }
    return distance_to(std::get<solids::Polytope>(form_), x, reach);
}

double Solid::at_least(const glm::dvec3& x, double reach) const {
    const auto* ellipsoid = std::get_if<solids::Ellipsoid>(&form_);
    if (ellipsoid == nullptr) return distance(x, reach);
    return (glm::length(ellipsoid->back * (x - ellipsoid->center)) - 1) * ellipsoid->thinnest;
}

Box3 Solid::extent(const Affine& place) const {
    if (const auto* ball = std::get_if<solids::Ball>(&form_))
        return box_around_ball(ball->center, glm::dmat3{ball->radius}, place);
    if (const auto* ellipsoid = std::get_if<solids::Ellipsoid>(&form_))
        return box_around_ball(ellipsoid->center, ellipsoid->axes, place);
    if (const auto* box = std::get_if<solids::Box>(&form_)) {
        std::vector<glm::dvec3> corners;
        for (const double x : {-1.0, 1.0})
            for (const double y : {-1.0, 1.0})
                for (const double z : {-1.0, 1.0})
                    corners.push_back(box->center + box->axes * (box->half * glm::dvec3{x, y, z}));
        return box_around(corners, place);
    }
    return box_around(std::get<solids::Polytope>(form_).corners, place);
}

}  // namespace pxm::host
