#include "host/fractal/bounds/filled.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <random>

#include "host/fractal/bounds/oriented_box.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_sets = 64;
constexpr double rounding = 1e-9;         // of a set's size
constexpr double thickness = 1.0 / 4;     // ... that is given to polygons
constexpr double much_flatter = 3.0 / 4;  // a map's ratio along a surface's direction to that aside
constexpr int tried_points = 2000;        // of a set

/// A number for each map, such as its determinant.
using OfMap = std::function<double(int map)>;

/// Whether the images' sizes may add up to those of the sets around them: M^n 1 neither vanishes
/// nor grows, with M the sums of `share` from set to set.
bool may_add_up(const Rifs& rifs, const OfMap& share) {
    constexpr int rounds = 64;
    constexpr double most = 1e3;  // of one set's size to another's
    std::vector<double> sizes(rifs.follow_sets.size(), 1.0);
    for (int round = 0; round < rounds; ++round) {
        std::vector<double> next(sizes.size(), 0.0);
        for (std::size_t set = 0; set < sizes.size(); ++set) {
            for (const int map : rifs.follow_sets[set].maps) {
                const auto at = static_cast<std::size_t>(map);
                next[set] += share(map) * sizes[static_cast<std::size_t>(rifs.follow_of[at])];
            }
        }
        sizes = next;
    }
    return std::ranges::all_of(sizes, [](double size) { return 1 / most < size && size < most; });
}

const Affine& map_of(const Rifs& rifs, int map) { return rifs.maps[static_cast<std::size_t>(map)]; }
std::size_t set_in(const Rifs& rifs, int map) {
    return static_cast<std::size_t>(rifs.follow_of[static_cast<std::size_t>(map)]);
}

/// Points of a set, from many of its cells.
Points scattered_points(const Rifs& rifs, const Points& one_of_each, std::size_t set) {
    constexpr int count = 40;
    constexpr int levels = 24;
    std::mt19937 random(1);
    Points points;
    for (int i = 0; i < count; ++i) {
        Affine place;
        std::size_t at = set;
        for (int level = 0; level < levels; ++level) {
            const std::vector<int>& maps = rifs.follow_sets[at].maps;
            const int map = maps[random() % maps.size()];
            place = then(map_of(rifs, map), place);
            at = set_in(rifs, map);
        }
        points.push_back(place.point(one_of_each[at]));
    }
    return points;
}

/// The normal of the plane that points lie in, if they do, and on no line.
std::optional<glm::dvec3> plane_of(const Points& points) {
    constexpr double on_line = 1e-3;
    const glm::dmat3 axes = principal_axes(points);
    glm::dvec3 low = glm::transpose(axes) * points.front(), high = low;
    for (const glm::dvec3& point : points) {
        low = glm::min(low, glm::transpose(axes) * point);
        high = glm::max(high, glm::transpose(axes) * point);
    }
    const glm::dvec3 wide = high - low;
    if (!(wide.z <= rounding * wide.x && on_line * wide.x <= wide.y)) return std::nullopt;
    return axes[2];
}

/// By how much a map changes areas in the plane with that normal.
double area_ratio(const Affine& map, const glm::dvec3& normal) {
    const glm::dvec3 other = std::abs(normal.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 u = glm::normalize(glm::cross(normal, other));
    return glm::length(glm::cross(map.direction(u), map.direction(glm::cross(normal, u))));
}

/// The direction that all maps keep and squash most, if there is one.
std::optional<glm::dvec3> flattened_direction(const Rifs& rifs) {
    constexpr int rounds = 100;
    glm::dvec3 along = glm::normalize(glm::dvec3{0.31, 0.57, 0.76});
    const Affine back = inverse(rifs.maps.front());
    for (int round = 0; round < rounds; ++round) along = glm::normalize(back.direction(along));
    for (const Affine& map : rifs.maps) {
        const glm::dvec3 image = map.direction(along);
        const double ratio = glm::length(image);
        if (glm::length(glm::cross(image, along)) > rounding * ratio) return std::nullopt;
        const double aside = std::sqrt(std::abs(determinant(map)) / ratio);
        if (!(ratio < much_flatter * aside)) return std::nullopt;
    }
    return along;
}

/// Points as hulls and coverings know them.
using Seen = std::function<glm::dvec3(const glm::dvec3&)>;

bool holds_images(const Rifs& rifs, const std::vector<ConvexHull>& hulls, const Seen& seen,
                  std::size_t set, double size) {
    return std::ranges::all_of(rifs.follow_sets[set].maps, [&](int map) {
        return std::ranges::all_of(hulls[set_in(rifs, map)].corners, [&](const glm::dvec3& corner) {
            return hulls[set].contains(seen(map_of(rifs, map).point(corner)), rounding * size);
        });
    });
}

/// A point of the hull of `corners`, more often than not near its boundary.
glm::dvec3 point_within(const Points& corners, std::mt19937& random) {
    std::uniform_real_distribution<double> share(0, 1);
    glm::dvec3 sum{0.0};
    double total = 0;
    for (const glm::dvec3& corner : corners) {
        const double weight = std::pow(share(random), 4);
        sum += weight * corner;
        total += weight;
    }
    return sum / total;
}

/// Whether points of a set's hull lie in images of the hulls of what may stand in it.
bool is_covered(const Rifs& rifs, const std::vector<ConvexHull>& hulls, const Seen& seen,
                const Points& corners, std::size_t set, double size) {
    std::mt19937 random(7);
    std::vector<std::pair<Affine, const ConvexHull*>> images;
    for (const int map : rifs.follow_sets[set].maps) {
        images.emplace_back(inverse(map_of(rifs, map)), &hulls[set_in(rifs, map)]);
    }
    for (int i = 0; i < tried_points; ++i) {
        const glm::dvec3 point = point_within(corners, random);
        const bool covered = std::ranges::any_of(images, [&](const auto& image) {
            const auto& [back, hull] = image;
            return hull->contains(seen(back.point(point)), 10 * rounding * size);
        });
        if (!covered) return false;
    }
    return true;
}

double size_of(const Points& points) {
    double size = 0;
    for (const glm::dvec3& point : points) size = std::max(size, glm::distance(point, points[0]));
    return size;
}

/// The hulls of all sets if they are what the system fills.
std::vector<ConvexHull> filled_hulls(const Rifs& rifs, const Seen& seen, bool flat) {
    std::vector<Points> corners = inner_points(rifs);
    std::vector<ConvexHull> hulls;
    std::vector<double> sizes;
    for (Points& points : corners) {
        for (glm::dvec3& point : points) point = seen(point);
        sizes.push_back(size_of(points));
        const double tolerance = rounding * sizes.back();
        const Points solid = flat ? thickened(points, tolerance, thickness * sizes.back()) : points;
        auto hull = convex_hull(solid, tolerance);
        if (!hull) return {};
        hulls.push_back(std::move(*hull));
    }
    for (std::size_t set = 0; set < hulls.size(); ++set) {
        if (!is_covered(rifs, hulls, seen, corners[set], set, sizes[set])) return {};
        // Thick polygons do not hold what maps make of them, but of the polygons themselves.
        std::vector<ConvexHull> inner = hulls;
        for (std::size_t i = 0; i < inner.size(); ++i) inner[i].corners = corners[i];
        if (!holds_images(rifs, inner, seen, set, sizes[set])) return {};
    }
    return hulls;
}

Filled solid_filling(const Rifs& rifs) {
    const auto share = [&](int map) { return std::abs(determinant(map_of(rifs, map))); };
    if (!may_add_up(rifs, share)) return {};
    auto hulls = filled_hulls(
        rifs, [](const glm::dvec3& x) { return x; }, false);
    if (hulls.empty()) return {};
    return {Filling::solid, std::move(hulls), {}};
}

Filled polygon_filling(const Rifs& rifs) {
    const Points one_of_each = inner_point_of_each(rifs);
    Filled result;
    for (std::size_t set = 0; set < rifs.follow_sets.size(); ++set) {
        const auto across = plane_of(scattered_points(rifs, one_of_each, set));
        if (!across) return {};
        result.across.push_back(*across);
    }
    const auto share = [&](int map) {
        return area_ratio(map_of(rifs, map), result.across[set_in(rifs, map)]);
    };
    if (!may_add_up(rifs, share)) return {};
    result.hulls = filled_hulls(
        rifs, [](const glm::dvec3& x) { return x; }, true);
    if (result.hulls.empty()) return {};
    result.filling = Filling::polygon;
    return result;
}

Filled surface_filling(const Rifs& rifs) {
    const auto along = flattened_direction(rifs);
    if (!along) return {};
    const auto share = [&](int map) {
        const Affine& of = map_of(rifs, map);
        return std::abs(determinant(of)) / glm::length(of.direction(*along));
    };
    if (!may_add_up(rifs, share)) return {};
    const auto seen = [&](const glm::dvec3& x) { return x - glm::dot(x, *along) * *along; };
    auto hulls = filled_hulls(rifs, seen, true);
    if (hulls.empty()) return {};
    return {Filling::surface, std::move(hulls),
            std::vector<glm::dvec3>(rifs.follow_sets.size(), *along)};
}

}  // namespace

Filled find_filling(const Rifs& rifs) {
    const bool regular = std::ranges::all_of(
        rifs.maps, [](const Affine& map) { return classify(map) != MapKind::singular; });
    if (!regular || rifs.follow_sets.size() > most_sets) return {};
    for (const auto& find : {solid_filling, polygon_filling, surface_filling}) {
        Filled found = find(rifs);
        if (found.filling != Filling::none) return found;
    }
    return {};
}

}  // namespace pxm::host
