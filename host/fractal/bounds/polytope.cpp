#include "host/fractal/bounds/polytope.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "host/fractal/bounds/support.hpp"

namespace pxm::host {

namespace {

constexpr double margin = 1e-9;  // of the size: added to each offset, unless rounding took more
constexpr double coordinate_margin = 1e-11;  // ... and of the coordinates
constexpr double tolerance = 1e-5;           // of the size: of each offset
constexpr double flat = 1e-3;                // of the size: points this near to a plane lie in it
constexpr double same_normal = 5e-3;         // distance of unit vectors
constexpr long budget = 200'000;             // cells looked at for an offset

void add_once(std::vector<glm::dvec3>& normals, const glm::dvec3& normal) {
    for (const glm::dvec3& other : normals) {
        if (glm::distance(other, normal) < same_normal) return;
    }
    normals.push_back(normal);
}

/// The side of the plane through a, b, c that has no points, as a normal; zero if both have.
glm::dvec3 free_side(const Points& points, const glm::dvec3& a, const glm::dvec3& b,
                     const glm::dvec3& c, double size) {
    const glm::dvec3 across = glm::cross(b - a, c - a);
    if (!(glm::length(across) > flat * size * size)) return glm::dvec3{0.0};
    const glm::dvec3 normal = glm::normalize(across);
    double low = 0;
    double high = 0;
    for (const glm::dvec3& point : points) {
        const double height = glm::dot(point - a, normal);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    if (high - low < flat * size) return glm::dvec3{0.0};  // all points lie in a plane
    if (high <= flat * size) return normal;
    return -low <= flat * size ? -normal : glm::dvec3{0.0};
}

/// The normals of the faces of the points' hull; too many or too few if it does not suit.
std::vector<glm::dvec3> face_normals(const Points& points, double size) {
    std::vector<glm::dvec3> normals;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
                const glm::dvec3 normal = free_side(points, points[i], points[j], points[k], size);
                if (normal != glm::dvec3{0.0}) add_once(normals, normal);
                if (normals.size() > most_half_spaces) return normals;
            }
        }
    }
    return normals;
}

/// The 26 directions of a cube's faces, edges and corners, and the principal axes.
std::vector<glm::dvec3> usual_normals(const Points& points) {
    std::vector<glm::dvec3> normals;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (x != 0 || y != 0 || z != 0)
                    normals.push_back(glm::normalize(glm::dvec3{x, y, z}));
            }
        }
    }
    const glm::dmat3 axes = principal_axes(points);
    for (int i = 0; i < 3; ++i) {
        add_once(normals, axes[i]);
        add_once(normals, -axes[i]);
    }
    return normals;
}

/// True if the half-spaces leave no direction open: the origin lies inside the normals' hull.
bool is_bounded(const std::vector<glm::dvec3>& normals) {
    for (const glm::dvec3& a : normals) {
        for (const glm::dvec3& b : normals) {
            // An edge of a cone that sees no normal in front of it would be open.
            const glm::dvec3 edge = glm::cross(a, b);
            if (glm::length(edge) < same_normal) continue;
            double most = 0;
            double least = 0;
            for (const glm::dvec3& normal : normals) {
                most = std::max(most, glm::dot(normal, edge));
                least = std::min(least, glm::dot(normal, edge));
            }
            if (most < same_normal * glm::length(edge) ||
                -least < same_normal * glm::length(edge)) {
                return false;
            }
        }
    }
    return normals.size() > 3;
}

/// An offset, and what it is more than the reach, rounding or not.
struct Offset {
    double with_margin;
    double room;
};

Offset offset(const Rifs& rifs, const Approximation& known, int set, const glm::dvec3& normal) {
    const Bounds& bounds = known.outer[set];
    const double size = bounds.ball.radius;
    const double far = glm::length(bounds.ball.center);
    const Reach found = reach(rifs, known, set, normal, tolerance * size, budget);
    const double with_margin = found.upper + margin * size + coordinate_margin * far;
    const double sure = found.at_most() + rounding_of(size + far);  // room in other coordinates
    return {std::max(with_margin, sure), std::max(below(with_margin - sure), 0.0)};
}

/// Where three planes meet, unless two of them are all but parallel.
std::optional<glm::dvec3> meeting_point(const HalfSpace& a, const HalfSpace& b,
                                        const HalfSpace& c) {
    constexpr double parallel = 1e-8;
    const glm::dvec3 bc = glm::cross(b.normal, c.normal);
    const double determinant = glm::dot(a.normal, bc);
    if (!(std::abs(determinant) > parallel)) return std::nullopt;
    return (a.offset * bc + b.offset * glm::cross(c.normal, a.normal) +
            c.offset * glm::cross(a.normal, b.normal)) /
           determinant;
}

double volume(const glm::dvec3& sides) { return sides.x * sides.y * sides.z; }

}  // namespace

Polytope polytope(const Rifs& rifs, const Approximation& known, int set) {
    const Points& points = known.inner[set];
    std::vector<glm::dvec3> normals = face_normals(points, known.outer[set].ball.radius);
    if (normals.size() > most_half_spaces || !is_bounded(normals)) normals = usual_normals(points);
    Polytope result;
    for (const glm::dvec3& normal : normals) {
        result.push_back({normal, offset(rifs, known, set, normal).with_margin});
    }
    return result;
}

std::vector<glm::dvec3> corners(const Polytope& polytope) {
    constexpr double on_plane = 1e-9;  // of the offsets
    double largest = 0;
    for (const HalfSpace& side : polytope) largest = std::max(largest, std::abs(side.offset));
    const auto contains = [&](const glm::dvec3& point) {
        return std::ranges::all_of(polytope, [&](const HalfSpace& side) {
            return glm::dot(side.normal, point) <= side.offset + on_plane * largest;
        });
    };
    std::vector<glm::dvec3> result;
    for (std::size_t i = 0; i < polytope.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
                const auto point = meeting_point(polytope[i], polytope[j], polytope[k]);
                if (point && contains(*point)) result.push_back(*point);
            }
        }
    }
    return result;
}

double diameter(const Polytope& polytope) {
    const std::vector<glm::dvec3> points = corners(polytope);
    double largest = 0;
    for (const glm::dvec3& a : points) {
        for (const glm::dvec3& b : points) largest = std::max(largest, glm::distance(a, b));
    }
    return largest;
}

OrientedBox oriented_box(const Rifs& rifs, const Approximation& known, int set) {
    const glm::dmat3 axes = principal_axes(known.inner[set]);
    glm::dvec3 low;
    glm::dvec3 high;
    double room = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const Offset down = offset(rifs, known, set, -axes[i]);
        const Offset up = offset(rifs, known, set, axes[i]);
        low[i] = -down.with_margin;
        high[i] = up.with_margin;
        room = std::min({room, down.room, up.room});
    }
    // Along the axes of the box that is up to sqrt 3 times as much.
    const double missing = 2 * shortfall_along(axes, low, high, coordinates(known, set)) - room;
    if (missing > 0) {
        low -= 2 * missing;
        high += 2 * missing;
    }
    const Box& box = known.outer[set].box;
    return volume(high - low) < volume(box.high - box.low) ? oriented_box(axes, low, high)
                                                           : as_oriented(box);
}

}  // namespace pxm::host
