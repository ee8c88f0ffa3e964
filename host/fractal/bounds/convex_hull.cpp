#include "host/fractal/bounds/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace pxm::host {

namespace {

struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

Span span_of(const Points& points, const glm::dvec3& u) {
    Span span;
    for (const glm::dvec3& point : points) {
        const double x = glm::dot(point, u);
        span.low = std::min(span.low, x);
        span.high = std::max(span.high, x);
    }
    return span;
}

bool known(const std::vector<HullFace>& faces, const HullFace& face, double tolerance) {
    constexpr double same_normal = 1e-9;
    return std::ranges::any_of(faces, [&](const HullFace& f) {
        return glm::distance(f.normal, face.normal) <= same_normal &&
               std::abs(f.offset - face.offset) <= 2 * tolerance;
    });
}

/// The faces among the planes through the first three points given, on either side.
void add_faces(const Points& points, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
               double tolerance, std::vector<HullFace>& faces) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double edges = glm::length(b - a) * glm::length(c - a);
    constexpr double thin = 1e-9;  // a triangle with no plane of its own
    if (!(glm::length(normal) > thin * edges)) return;
    for (const double side : {1.0, -1.0}) {
        const glm::dvec3 u = side * glm::normalize(normal);
        const HullFace face{u, glm::dot(u, a)};
        if (span_of(points, u).high > face.offset + tolerance) continue;
        if (!known(faces, face, tolerance)) faces.push_back(face);
    }
}

Points without_repeats(const Points& points, double tolerance) {
    Points result;
    for (const glm::dvec3& point : points) {
        const auto same = [&](const glm::dvec3& other) {
            return glm::distance(point, other) <= tolerance;
        };
        if (std::ranges::none_of(result, same)) result.push_back(point);
    }
    return result;
}

/// A corner lies on faces whose normals span all directions.
bool is_corner(const glm::dvec3& point, const std::vector<HullFace>& faces, double tolerance) {
    std::vector<glm::dvec3> normals;
    for (const HullFace& face : faces) {
        if (glm::dot(face.normal, point) < face.offset - 2 * tolerance) continue;
        normals.push_back(face.normal);
    }
    constexpr double some_volume = 1e-9;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const glm::dvec3 edge = glm::cross(normals[i], normals[j]);
            for (std::size_t k = 0; k < j; ++k) {
                if (std::abs(glm::dot(edge, normals[k])) > some_volume) return true;
            }
        }
    }
    return false;
}

Points images(const ConvexHull& polytope, const Affine& map) {
    Points result;
    for (const glm::dvec3& corner : polytope.corners) result.push_back(map.point(corner));
    return result;
}

glm::dvec3 centre(const Points& points) {
    glm::dvec3 sum{0.0};
    for (const glm::dvec3& point : points) sum += point;
    return sum / static_cast<double>(points.size());
}

/// A plane across u lies between the two. Two flat sets within one plane do not count.
bool separates(const glm::dvec3& u, const Points& a, const Points& b, double tolerance) {
    const double length = glm::length(u);
    if (!(length > 0)) return false;
    const Span x = span_of(a, u / length);
    const Span y = span_of(b, u / length);
    if (x.high - x.low <= tolerance && y.high - y.low <= tolerance) {
        return x.low > y.high + tolerance || y.low > x.high + tolerance;
    }
    return x.high <= y.low + tolerance || y.high <= x.low + tolerance;
}

bool separated_along_faces(const ConvexHull& polytope, const Affine& map, const Points& a,
                           const Points& b, double tolerance) {
    if (!(std::abs(determinant(map)) > 0)) return false;
    const glm::dmat3 normals = glm::transpose(glm::inverse(map.linear));
    return std::ranges::any_of(polytope.faces, [&](const HullFace& face) {
        return separates(normals * face.normal, a, b, tolerance);
    });
}

bool separated_along_axes(const Points& a, const Points& b, double tolerance) {
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = 0; z <= 1; ++z) {
                if (separates({x, y, z}, a, b, tolerance)) return true;
            }
        }
    }
    return false;
}

/// A unit vector across `u` (and `v`, unless it is zero).
glm::dvec3 across(const glm::dvec3& u, const glm::dvec3& v) {
    const glm::dvec3 cross = glm::cross(u, v);
    if (glm::length(cross) > 0) return glm::normalize(cross);
    const glm::dvec3 size = glm::abs(u);
    const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3{1, 0, 0}
                            : size.y <= size.z                   ? glm::dvec3{0, 1, 0}
                                                                 : glm::dvec3{0, 0, 1};
    return glm::normalize(glm::cross(u, axis));
}

/// The point farthest by some measure, and that measure.
template <class Measure>
glm::dvec3 farthest_by(const Points& points, const Measure& measure, double& distance) {
    glm::dvec3 best = points.front();
    for (const glm::dvec3& point : points) {
        if (measure(point) > measure(best)) best = point;
    }
    distance = measure(best);
    return best;
}

/// Directions in which the points have no extent, perpendicular to each other.
std::vector<glm::dvec3> flat_directions(const Points& points, double tolerance) {
    const glm::dvec3 a = points.front();
    double distance = 0;
    const glm::dvec3 b = farthest_by(
        points, [&](const glm::dvec3& p) { return glm::distance(p, a); }, distance);
    if (distance <= tolerance) return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const glm::dvec3 along = glm::normalize(b - a);
    const glm::dvec3 c = farthest_by(
        points, [&](const glm::dvec3& p) { return glm::length(glm::cross(p - a, along)); },
        distance);
    if (distance <= tolerance) {
        const glm::dvec3 side = across(along, glm::dvec3{0.0});
        return {side, across(along, side)};
    }
    const glm::dvec3 normal = across(along, c - a);
    farthest_by(
        points, [&](const glm::dvec3& p) { return std::abs(glm::dot(p - a, normal)); }, distance);
    if (distance <= tolerance) return {normal};
    return {};
}

}  // namespace

bool ConvexHull::contains(const glm::dvec3& point, double tolerance) const {
    return std::ranges::all_of(faces, [&](const HullFace& face) {
        return glm::dot(face.normal, point) <= face.offset + tolerance;
    });
}

std::optional<ConvexHull> convex_hull(const Points& points, double tolerance) {
    const Points distinct = without_repeats(points, tolerance);
    const std::size_t n = distinct.size();
    if (n < 4 || n > most_corners) return std::nullopt;
    ConvexHull hull;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
                add_faces(distinct, distinct[i], distinct[j], distinct[k], tolerance, hull.faces);
            }
        }
    }
    for (const glm::dvec3& point : distinct) {
        if (is_corner(point, hull.faces, tolerance)) hull.corners.push_back(point);
    }
    if (hull.corners.size() < 4) return std::nullopt;
    return hull;
}

Points thickened(const Points& points, double tolerance, double thickness) {
    Points result = points;
    for (const glm::dvec3& direction : flat_directions(points, tolerance)) {
        Points both;
        for (const glm::dvec3& point : result) {
            both.push_back(point - thickness * direction);
            both.push_back(point + thickness * direction);
        }
        result = std::move(both);
    }
    return result;
}

bool separated(const ConvexHull& a, const Affine& image_a, const ConvexHull& b,
               const Affine& image_b, double tolerance) {
    const Points x = images(a, image_a);
    const Points y = images(b, image_b);
    return separated_along_axes(x, y, tolerance) ||
           separates(centre(y) - centre(x), x, y, tolerance) ||
           separated_along_faces(a, image_a, x, y, tolerance) ||
           separated_along_faces(b, image_b, x, y, tolerance);
}

}  // namespace pxm::host
