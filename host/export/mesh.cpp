#include "host/export/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "dsp_kernels/scene_block.hpp"
#include "host/fractal/bounds/polytope.hpp"

namespace pxm::host {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Face = std::vector<std::uint32_t>;

constexpr int prism_sides = 32;

Mesh box_mesh(const glm::dvec3& center, const std::array<glm::dvec3, 3>& half) {
    Mesh mesh;
    for (unsigned corner = 0; corner < 8; ++corner) {
        glm::dvec3 place = center;
        for (unsigned axis = 0; axis < 3; ++axis)
            place += (corner >> axis & 1U) != 0 ? half[axis] : -half[axis];
        mesh.vertices.push_back(place);
    }
    mesh.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                  {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    if (volume_of(mesh) < 0) turn_over(mesh);  // axes that are left-handed
    return mesh;
}

/// The number of the point in the middle of an edge, on the unit ball.
std::uint32_t middle(Mesh& mesh, std::map<Edge, std::uint32_t>& known, std::uint32_t a,
                     std::uint32_t b) {
    const auto [found, added] = known.emplace(std::minmax(a, b), mesh.vertices.size());
    if (added) mesh.vertices.push_back(glm::normalize(mesh.vertices[a] + mesh.vertices[b]));
    return found->second;
}

/// An icosahedron with its faces cut in four.
Mesh ball_mesh(const glm::dvec3& center, double radius) {
    constexpr double phi = std::numbers::phi;
    Mesh mesh;
    for (const double one : {-1.0, 1.0})
        for (const double p : {-phi, phi})
            for (const glm::dvec3& v : {glm::dvec3{0, one, p}, {one, p, 0}, {p, 0, one}})
                mesh.vertices.push_back(glm::normalize(v));
    const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
    const double edge = 2 / std::sqrt(1 + phi * phi) * 1.01;
    const auto near = [&](std::uint32_t a, std::uint32_t b) {
        return glm::distance(mesh.vertices[a], mesh.vertices[b]) < edge;
    };
    std::vector<Face> coarse;
    for (std::uint32_t a = 0; a < count; ++a)
        for (std::uint32_t b = a + 1; b < count; ++b)
            for (std::uint32_t c = b + 1; c < count; ++c) {
                if (!near(a, b) || !near(b, c) || !near(a, c)) continue;
                const glm::dvec3& v = mesh.vertices[a];
                const bool outward =
                    glm::dot(v, glm::cross(mesh.vertices[b], mesh.vertices[c])) > 0;
                coarse.push_back(outward ? Face{a, b, c} : Face{a, c, b});
            }
    std::map<Edge, std::uint32_t> known;
    for (const Face& f : coarse) {
        const std::uint32_t ab = middle(mesh, known, f[0], f[1]);
        const std::uint32_t bc = middle(mesh, known, f[1], f[2]);
        const std::uint32_t ca = middle(mesh, known, f[2], f[0]);
        for (const Face& part : {Face{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}})
            mesh.faces.push_back(part);
    }
    for (glm::dvec3& v : mesh.vertices) v = center + radius * v;
    return mesh;
}

/// Between y = low and y = high about the y axis; its upper radius may be 0.
Mesh prism(double low, double high, double upper_radius) {
    Mesh mesh;
    Face bottom, top;
    const auto at = [](int side, double y, double radius) {
        const double angle = 2 * std::numbers::pi * side / prism_sides;
        return glm::dvec3{radius * std::cos(angle), y, radius * std::sin(angle)};
    };
    for (int side = 0; side < prism_sides; ++side) {
        bottom.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back(at(side, low, 1));
    }
    for (int side = 0; side < (upper_radius > 0 ? prism_sides : 1); ++side) {
        top.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back(at(side, high, upper_radius));
    }
    for (std::size_t i = 0; i < bottom.size(); ++i) {
        const std::size_t j = (i + 1) % bottom.size();
        if (top.size() > 1)
            mesh.faces.push_back({bottom[i], top[i], top[j], bottom[j]});
        else
            mesh.faces.push_back({bottom[i], top[0], bottom[j]});
    }
    mesh.faces.push_back(bottom);
    if (top.size() > 1) mesh.faces.emplace_back(top.rbegin(), top.rend());
    return mesh;
}

/// Cuts off what lies outside of a half-space. Which side a corner is on is decided once, and an
/// edge is cut at one point, so that what was closed stays closed.
void cut(Mesh& mesh, const HalfSpace& side) {
    std::vector<double> outside;
    for (const glm::dvec3& v : mesh.vertices)
        outside.push_back(glm::dot(side.normal, v) - side.offset);
    std::map<Edge, std::uint32_t> cuts;
    const auto cut_at = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, added] = cuts.emplace(std::minmax(a, b), mesh.vertices.size());
        if (added) {
            const auto [low, high] = found->first;
            const double share = outside[low] / (outside[low] - outside[high]);
            mesh.vertices.push_back(mesh.vertices[low] +
                                    share * (mesh.vertices[high] - mesh.vertices[low]));
        }
        return found->second;
    };
    std::vector<Face> kept;
    std::map<std::uint32_t, std::uint32_t> rim;  // what follows what, round the new face
    for (const Face& face : mesh.faces) {
        Face rest;
        std::uint32_t left = 0, entered = 0;
        bool is_cut = false;
        for (std::size_t i = 0; i < face.size(); ++i) {
            const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
            if (outside[a] <= 0) rest.push_back(a);
            if ((outside[a] <= 0) == (outside[b] <= 0)) continue;
            rest.push_back(cut_at(a, b));
            (outside[a] <= 0 ? left : entered) = rest.back();
            is_cut = true;
        }
        if (is_cut) rim[entered] = left;
        if (rest.size() > 2) kept.push_back(std::move(rest));
    }
    mesh.faces = std::move(kept);
    if (rim.empty()) return;
    Face cap;
    std::uint32_t at = rim.begin()->first;
    for (std::size_t i = 0; i < rim.size() && rim.contains(at); ++i) {
        cap.push_back(at);
        at = rim.at(at);
    }
    if (cap.size() > 2) mesh.faces.push_back(std::move(cap));
}

/// Only the vertices that a face uses.
Mesh tidy(const Mesh& mesh) {
    Mesh result;
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (Face face : mesh.faces) {
        for (std::uint32_t& corner : face) {
            const auto [found, added] = numbers.emplace(corner, result.vertices.size());
            if (added) result.vertices.push_back(mesh.vertices[corner]);
            corner = found->second;
        }
        result.faces.push_back(std::move(face));
    }
    return result;
}

Mesh hull_mesh(const CompiledVolume& volume) {
    const double reach = 4 * volume.diameter;
    const std::array<glm::dvec3, 3> half{
        {{reach, 0, 0}, {0, reach * 1.01, 0}, {0, 0, reach * 1.02}}};
    Mesh mesh = box_mesh(volume.center, half);
    for (const HalfSpace& side : volume.half_spaces) cut(mesh, side);
    mesh = tidy(mesh);
    if (is_closed(mesh) && volume_of(mesh) > 0) return mesh;
    // Planes that all but agree: the box around the corners holds it as well.
    glm::dvec3 low{INFINITY}, high{-INFINITY};
    for (const glm::dvec3& corner : corners(volume.half_spaces)) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const glm::dvec3 h = (high - low) / 2.0;
    return box_mesh((low + high) / 2.0, {{{h.x, 0, 0}, {0, h.y, 0}, {0, 0, h.z}}});
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Face& face : mesh.faces)
        for (std::size_t i = 2; i < face.size(); ++i)
            triangles.push_back({face[0], face[i - 1], face[i]});
    return triangles;
}

double volume_of(const Mesh& mesh) {
    if (mesh.vertices.empty()) return 0;
    const glm::dvec3 origin = mesh.vertices.front();
    double volume = 0;
    for (const auto& [a, b, c] : triangles_of(mesh))
        volume += glm::dot(mesh.vertices[a] - origin,
                           glm::cross(mesh.vertices[b] - origin, mesh.vertices[c] - origin)) /
                  6;
    return volume;
}

bool is_closed(const Mesh& mesh) {
    std::map<Edge, int> sides;
    for (const Face& face : mesh.faces)
        for (std::size_t i = 0; i < face.size(); ++i)
            ++sides[{face[i], face[(i + 1) % face.size()]}];
    return !sides.empty() && std::ranges::all_of(sides, [&](const auto& side) {
        const auto other = sides.find({side.first.second, side.first.first});
        return side.second == 1 && other != sides.end();
    });
}

void turn_over(Mesh& mesh) {
    for (Face& face : mesh.faces) std::ranges::reverse(face);
}

Mesh image_of(const Mesh& mesh, const Affine& map) {
    Mesh image = mesh;
    for (glm::dvec3& v : image.vertices) v = map.point(v);
    if (determinant(map) < 0) turn_over(image);
    return image;
}

Mesh mesh_of(const CompiledVolume& volume) {
    switch (volume.kind) {
        case kernels::Volume::sphere:
            return ball_mesh(volume.center, volume.radius);
        case kernels::Volume::box: {
            const glm::dvec3 h = (volume.high - volume.low) / 2.0;
            return box_mesh((volume.low + volume.high) / 2.0,
                            {{{h.x, 0, 0}, {0, h.y, 0}, {0, 0, h.z}}});
        }
        case kernels::Volume::oriented:
            return box_mesh(volume.center, volume.half);
        case kernels::Volume::cone:
            return prism(0, 1, 0);
        case kernels::Volume::cylinder:
            return prism(-1, 1, 1);
        default:
            break;
    }
    return hull_mesh(volume);
}

}  // namespace pxm::host
