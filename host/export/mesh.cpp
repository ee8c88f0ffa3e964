#include "host/export/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

#include "host/fractal/bounds/polytope.hpp"

namespace pxm::host {

namespace {

constexpr std::uint32_t around = 32;  // sides of what stands for a circle
constexpr int rounds = 2;             // of cutting an icosahedron's triangles into four

using Triangle = std::array<std::uint32_t, 3>;

void add(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.push_back({a, b, c});
}

Mesh icosahedron() {
    Mesh mesh;
    const double g = std::numbers::phi;
    for (const double s : {-1.0, 1.0}) {
        for (const double t : {-g, g}) {
            mesh.vertices.push_back(glm::normalize(glm::dvec3{0, s, t}));
            mesh.vertices.push_back(glm::normalize(glm::dvec3{s, t, 0}));
            mesh.vertices.push_back(glm::normalize(glm::dvec3{t, 0, s}));
        }
    }
    // Its faces are the triples of corners that are nearest to each other.
    const double edge = 1.1 * 2 / std::sqrt(g * g + 1);
    const auto near = [&](std::uint32_t i, std::uint32_t j) {
        return glm::distance(mesh.vertices[i], mesh.vertices[j]) < edge;
    };
    for (std::uint32_t i = 0; i < 12; ++i) {
        for (std::uint32_t j = i + 1; j < 12; ++j) {
            for (std::uint32_t k = j + 1; k < 12; ++k) {
                if (near(i, j) && near(j, k) && near(k, i)) add(mesh, i, j, k);
            }
        }
    }
    return mesh;
}

/// Each triangle as four, the new corners on the unit ball.
Mesh divided(const Mesh& mesh) {
    Mesh finer;
    finer.vertices = mesh.vertices;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t i, std::uint32_t j) {
        const auto [at, is_new] = middles.try_emplace(
            std::minmax(i, j), static_cast<std::uint32_t>(finer.vertices.size()));
        if (is_new) finer.vertices.push_back(glm::normalize(mesh.vertices[i] + mesh.vertices[j]));
        return at->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        finer.triangles.insert(finer.triangles.end(),
                               {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return finer;
}

Mesh unit_ball() {
    Mesh mesh = icosahedron();
    for (int i = 0; i < rounds; ++i) mesh = divided(mesh);
    return mesh;
}

/// The box center + sum of t_i half[i], |t_i| <= 1.
Mesh box_mesh(const glm::dvec3& center, const std::array<glm::dvec3, 3>& half) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back(center + (i & 1 ? half[0] : -half[0]) +
                                (i & 2 ? half[1] : -half[1]) + (i & 4 ? half[2] : -half[2]));
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// The fan from `first` over corners in order.
void add_fan(Mesh& mesh, const std::vector<std::uint32_t>& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        add(mesh, corners[0], corners[i - 1], corners[i]);
}

/// The unit cone: apex above the unit circle; or the unit cylinder between two of them.
Mesh round_mesh(bool cone, double low, double high) {
    Mesh mesh;
    std::vector<std::uint32_t> bottom, top;
    for (std::uint32_t i = 0; i < around; ++i) {
        const double turn = 2 * std::numbers::pi * i / around;
        bottom.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back({std::cos(turn), low, std::sin(turn)});
        if (cone) continue;
        top.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        mesh.vertices.push_back({std::cos(turn), high, std::sin(turn)});
    }
    if (cone) {
        mesh.vertices.push_back({0, high, 0});
        top.assign(around, static_cast<std::uint32_t>(mesh.vertices.size() - 1));
    }
    for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t next = (i + 1) % around;
        add(mesh, bottom[i], top[i], bottom[next]);
        if (!cone) add(mesh, top[i], top[next], bottom[next]);
    }
    add_fan(mesh, bottom);
    if (!cone) {
        std::ranges::reverse(top);
        add_fan(mesh, top);
    }
    return mesh;
}

/// Corners that lie in a plane, in order around its normal.
std::vector<std::uint32_t> around_face(const std::vector<glm::dvec3>& corners,
                                       const HalfSpace& side, double size) {
    std::vector<std::uint32_t> face;
    glm::dvec3 middle{0.0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (glm::dot(side.normal, corners[i]) < side.offset - 1e-7 * size) continue;
        face.push_back(static_cast<std::uint32_t>(i));
        middle += corners[i];
    }
    if (face.size() < 3) return {};
    middle /= static_cast<double>(face.size());
    const glm::dvec3 other =
        std::abs(side.normal.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 u = glm::normalize(glm::cross(other, side.normal));
    const glm::dvec3 v = glm::cross(side.normal, u);
    std::ranges::sort(face, {}, [&](std::uint32_t i) {
        const glm::dvec3 from = corners[i] - middle;
        return std::atan2(glm::dot(from, v), glm::dot(from, u));
    });
    return face;
}

Mesh hull_mesh(const CompiledVolume& volume) {
    Mesh mesh;
    for (const glm::dvec3& corner : corners(volume.half_spaces)) {
        const bool known = std::ranges::any_of(mesh.vertices, [&](const glm::dvec3& other) {
            return glm::distance(corner, other) < 1e-7 * volume.diameter;
        });
        if (!known) mesh.vertices.push_back(corner);
    }
    for (const HalfSpace& side : volume.half_spaces)
        add_fan(mesh, around_face(mesh.vertices, side, volume.diameter));
    return mesh;
}

/// The box that stands for a hull whose planes are too many at a corner to be told apart.
Mesh box_around(const std::vector<glm::dvec3>& points) {
    glm::dvec3 low = points.front(), high = low;
    for (const glm::dvec3& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const glm::dvec3 half = (high - low) / 2.0;
    return box_mesh((low + high) / 2.0, {{{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}}});
}

Mesh turned_outward(Mesh mesh) {
    glm::dvec3 middle{0.0};
    for (const glm::dvec3& vertex : mesh.vertices) middle += vertex;
    middle /= static_cast<double>(mesh.vertices.size());
    for (Triangle& t : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[t[0]];
        const glm::dvec3 across = glm::cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
        if (glm::dot(across, a - middle) < 0) std::swap(t[1], t[2]);
    }
    return mesh;
}

}  // namespace

Mesh mesh_of(const CompiledVolume& volume) {
    using kernels::Volume;
    Mesh mesh;
    switch (volume.kind) {
        case Volume::sphere:
            mesh = unit_ball();
            for (glm::dvec3& vertex : mesh.vertices)
                vertex = volume.center + volume.radius * vertex;
            break;
        case Volume::box: {
            const glm::dvec3 half = (volume.high - volume.low) / 2.0;
            mesh = box_mesh((volume.low + volume.high) / 2.0,
                            {{{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}}});
            break;
        }
        case Volume::oriented:
            mesh = box_mesh(volume.center, volume.half);
            break;
        case Volume::hull:
            mesh = turned_outward(hull_mesh(volume));
            if (!is_closed(mesh)) mesh = box_around(mesh.vertices);
            break;
        case Volume::cone:
        case Volume::cylinder:
            // Both stand on the unit circle; the cone's is at y = 0, its apex at 1.
            mesh = round_mesh(volume.kind == Volume::cone, volume.kind == Volume::cone ? 0 : -1, 1);
            for (glm::dvec3& vertex : mesh.vertices)
                vertex = volume.center + volume.radius * vertex;
            break;
    }
    return turned_outward(std::move(mesh));
}

double volume_inside(const Mesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        sum += glm::dot(mesh.vertices[a], glm::cross(mesh.vertices[b], mesh.vertices[c])) / 6;
    }
    return sum;
}

bool is_closed(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    }
    return !edges.empty() && std::ranges::all_of(edges, [&](const auto& edge) {
        const auto back = edges.find({edge.first.second, edge.first.first});
        return edge.second == 1 && back != edges.end() && back->second == 1;
    });
}

}  // namespace pxm::host
