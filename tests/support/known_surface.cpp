#include "tests/support/known_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

namespace pxm::test {

using namespace host;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The depths at which a line is on the graph.
std::vector<double> crossings(const KnownSurface::Graph& graph, const Sight& ray) {
    const glm::dvec3& o = ray.origin;
    const glm::dvec3& d = ray.direction;
    const double a = graph.xx * d.x * d.x + graph.xy * d.x * d.y + graph.yy * d.y * d.y;
    const double b = 2 * graph.xx * o.x * d.x + graph.xy * (o.x * d.y + o.y * d.x) +
                     2 * graph.yy * o.y * d.y + graph.x * d.x - d.z;
    const double c =
        graph.xx * o.x * o.x + graph.xy * o.x * o.y + graph.yy * o.y * o.y + graph.x * o.x - o.z;
    if (std::abs(a) < 1e-12) return b == 0 ? std::vector<double>{} : std::vector{-c / b};
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return {};
    const double q = b < 0 ? (std::sqrt(discriminant) - b) / 2 : -(std::sqrt(discriminant) + b) / 2;
    if (q == 0) return {0.0};
    return {std::min(q / a, c / q), std::max(q / a, c / q)};
}

/// The part of a line within all sides, and the side where it enters.
struct Within {
    double entry = -infinity;
    double exit = infinity;
    glm::dvec3 normal{0.0};
};
Within within(const std::vector<HalfSpace>& sides, const Sight& ray, double grown) {
    Within result;
    for (const HalfSpace& side : sides) {
        const double slope = glm::dot(side.normal, ray.direction);
        const double left = side.offset + grown - glm::dot(side.normal, ray.origin);
        if (std::abs(slope) < 1e-15) {
            if (left < 0) result.exit = -infinity;
        } else if (slope > 0) {
            result.exit = std::min(result.exit, left / slope);
        } else if (left / slope > result.entry) {
            result.entry = left / slope;
            result.normal = side.normal;
        }
    }
    return result;
}

glm::dvec3 gradient(const KnownSurface::Graph& graph, const glm::dvec3& p) {
    return {2 * graph.xx * p.x + graph.xy * p.y + graph.x, graph.xy * p.x + 2 * graph.yy * p.y, -1};
}

HalfSpace side(const glm::dvec3& outward, double offset) {
    const double length = glm::length(outward);
    return {outward / length, offset / length};
}

/// low <= x, y <= high.
std::vector<HalfSpace> over_square(double low, double high) {
    return {side({1, 0, 0}, high), side({-1, 0, 0}, -low), side({0, 1, 0}, high),
            side({0, -1, 0}, -low)};
}

/// Four maps to the quarters of [low, high]^2, each x' = (x + a) / 2 with a in {low, high}. A
/// quadratic form has q(x') = q(x) / 4 + the rest, which is linear in x and y.
std::string quarters(const KnownSurface::Graph& graph, double low, double high) {
    std::string maps;
    for (const double b : {low, high}) {
        for (const double a : {low, high}) {
            const double to_x = graph.xx * a / 2 + graph.xy * b / 4 + graph.x / 4;
            const double to_y = graph.yy * b / 2 + graph.xy * a / 4;
            const double height =
                (graph.xx * a * a + graph.xy * a * b + graph.yy * b * b) / 4 + graph.x * a / 2;
            maps += fmt::format("newmap matrix: 1/2,0,{}, 0,1/2,{}, 0,0,1/4, {},{},{}\n", to_x,
                                to_y, a / 2, b / 2, height);
        }
    }
    return maps;
}

/// Copies of half the size, moved.
std::string halves(const std::vector<glm::dvec3>& corners, const std::string& turn = "") {
    std::string maps;
    for (const glm::dvec3& p : corners) {
        maps += fmt::format("newmap scale: 1/2 {} translate: {},{},{}\n", turn, p.x, p.y, p.z);
    }
    return maps;
}

/// The half cubes of the simplex 0 <= z <= y <= x <= 1, in each of which it is the union of the
/// simplices u >= v >= w for some orders (u, v, w) of the axes.
std::string simplex_maps() {
    using Order = std::array<int, 3>;
    const auto pieces = [](const glm::dvec3& corner, const std::vector<Order>& orders) {
        std::string maps;
        for (const Order& order : orders) {
            glm::dmat3 turn{0.0};  // row i of the matrix: where axis i goes
            for (int i = 0; i < 3; ++i) turn[i][order[static_cast<std::size_t>(i)]] = 0.5;
            maps += "newmap matrix: ";
            for (int i = 0; i < 3; ++i) {
                maps += fmt::format("{},{},{}, ", turn[i].x, turn[i].y, turn[i].z);
            }
            maps += fmt::format("{},{},{}\n", corner.x, corner.y, corner.z);
        }
        return maps;
    };
    return pieces({0, 0, 0}, {{0, 1, 2}}) + pieces({0.5, 0, 0}, {{0, 1, 2}, {1, 0, 2}, {1, 2, 0}}) +
           pieces({0.5, 0.5, 0}, {{0, 1, 2}, {0, 2, 1}, {2, 0, 1}}) +
           pieces({0.5, 0.5, 0.5}, {{0, 1, 2}});
}

KnownSurface over_unit_square(const std::string& name, const KnownSurface::Graph& graph) {
    return {name, quarters(graph, 0, 1), graph, over_square(0, 1)};
}

/// The unit cube in n^3 parts.
KnownSurface cube(const std::string& name, int n) {
    std::vector<HalfSpace> sides = over_square(0, 1);
    sides.push_back(side({0, 0, 1}, 1));
    sides.push_back(side({0, 0, -1}, 0));
    std::string maps;
    for (int i = 0; i < n * n * n; ++i) {
        maps += fmt::format("newmap scale: 1/{0} translate: {1}/{0},{2}/{0},{3}/{0}\n", n, i % n,
                            i / n % n, i / n / n);
    }
    return {name, maps, {}, sides};
}

KnownSurface prism() {
    std::string maps;
    for (const double z : {0.0, 0.5}) {
        maps += halves({{0, 0, z}, {0.5, 0, z}, {0, 0.5, z}}) +
                halves({{0.5, 0.5, z}}, "rotate: z,180");
    }
    return {"prism",
            maps,
            {},
            {side({-1, 0, 0}, 0), side({0, -1, 0}, 0), side({1, 1, 0}, 1), side({0, 0, -1}, 0),
             side({0, 0, 1}, 1)}};
}

KnownSurface simplex() {
    return {"simplex",
            simplex_maps(),
            {},
            {side({0, 0, -1}, 0), side({0, -1, 1}, 0), side({-1, 1, 0}, 0), side({1, 0, 0}, 1)}};
}

/// The simplex without its uppermost eighth.
KnownSurface wedge() {
    std::string maps = simplex_maps();
    std::string pieces = maps.substr(0, maps.rfind("newmap"));
    KnownSurface result = simplex();
    result.name = "wedge";
    result.maps = maps + pieces + "start: 9, 10, 11, 12, 13, 14, 15\n";
    for (int i = 1; i <= 15; ++i) {
        result.maps += fmt::format("follow: {} -> 1, 2, 3, 4, 5, 6, 7, 8\n", i);
    }
    result.sides.push_back(side({0, 0, 1}, 0.5));
    return result;
}

KnownSurface triangle() {
    return {
        "triangle",
        halves({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}}) + halves({{0.5, 0.5, 0}}, "rotate: z,180"),
        KnownSurface::Graph{},
        {side({-1, 0, 0}, 0), side({0, -1, 0}, 0), side({1, 1, 0}, 1)}};
}

}  // namespace

bool KnownSurface::is_curved() const {
    return graph && (graph->xx != 0 || graph->xy != 0 || graph->yy != 0);
}

std::optional<SurfaceHit> KnownSurface::hit(const Sight& ray, double grown) const {
    const Within inside = within(sides, ray, grown);
    if (!graph) {
        if (inside.exit < inside.entry || inside.entry < 0) return {};
        return SurfaceHit{inside.entry, inside.normal};
    }
    for (const double t : crossings(*graph, ray)) {
        if (t < 0 || t < inside.entry || inside.exit < t) continue;
        const glm::dvec3 normal = glm::normalize(gradient(*graph, ray.origin + t * ray.direction));
        return SurfaceHit{t, glm::dot(normal, ray.direction) > 0 ? -normal : normal};
    }
    return {};
}

double KnownSurface::distance(const glm::dvec3& point) const {
    double farthest = 0;
    for (const HalfSpace& one : sides) {
        farthest = std::max(farthest, glm::dot(one.normal, point) - one.offset);
    }
    if (!graph) return farthest;
    const double height = graph->xx * point.x * point.x + graph->xy * point.x * point.y +
                          graph->yy * point.y * point.y + graph->x * point.x;
    return std::max(farthest, std::abs(point.z - height) / glm::length(gradient(*graph, point)));
}

std::vector<KnownSurface> known_surfaces() {
    KnownSurface slope = over_unit_square("slope", {0, 0, 0, 1});
    slope.maps = halves({{0, 0, 0}, {0.5, 0, 0.5}, {0, 0.5, 0}, {0.5, 0.5, 0.5}});
    KnownSurface square = over_unit_square("square", {});
    square.maps = halves({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0.5, 0.5, 0}});
    return {slope,
            square,
            triangle(),
            over_unit_square("saddle", {0, 1, 0, 0}),
            over_unit_square("paraboloid", {1, 0, 1, 0}),
            cube("cube", 2),
            cube("cube_of_thirds", 3),
            cube("cube_of_fifths", 5),
            prism(),
            simplex(),
            wedge()};
}

KnownSurface known_surface(const std::string& name) {
    for (KnownSurface& one : known_surfaces()) {
        if (one.name == name) return one;
    }
    throw std::runtime_error("no surface of that name: " + name);
}

}  // namespace pxm::test
