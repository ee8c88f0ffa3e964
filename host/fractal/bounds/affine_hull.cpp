#include "host/fractal/bounds/affine_hull.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "host/fractal/bounds/inner_points.hpp"
#include "host/fractal/system/growth.hpp"
#include "host/math/lipschitz.hpp"
#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

constexpr double rounding = 1e-11;

double largest_part(const glm::dvec3& x) {
    return std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
}

double size_of(const glm::dmat3& linear) {
    return std::sqrt(glm::dot(linear[0], linear[0]) + glm::dot(linear[1], linear[1]) +
                     glm::dot(linear[2], linear[2]));
}

/// What of x no axis explains. Twice, since the first difference may be small.
glm::dvec3 outside(const AffineHull& hull, glm::dvec3 x) {
    for (int round = 0; round < 2; ++round) {
        for (int i = 0; i < hull.dimension; ++i) x -= glm::dot(x, hull.axes[i]) * hull.axes[i];
    }
    return x;
}

/// Adds a direction. False if it is one already, up to `error`.
bool add(AffineHull& hull, const glm::dvec3& direction, double error) {
    if (hull.dimension == 3) return false;
    const glm::dvec3 rest = outside(hull, direction);
    const double length = glm::length(rest);
    if (!(length > error)) return false;
    hull.axes[hull.dimension++] = rest / length;
    return true;
}

/// Adds what the image of a hull has outside of this one.
bool add_image(AffineHull& hull, const Affine& map, const AffineHull& inside) {
    const double size = size_of(map.linear);
    const glm::dvec3 image = map.point(inside.point);
    const double places = largest_part(hull.point) + size * largest_part(inside.point) +
                          largest_part(map.translation);
    bool grown = add(hull, image - hull.point, rounding * places);
    for (int i = 0; i < inside.dimension; ++i) {
        grown = add(hull, map.direction(inside.axes[i]), rounding * size) || grown;
    }
    return grown;
}

bool same_directions(const AffineHull& a, const AffineHull& b) {
    if (a.dimension != b.dimension) return false;
    for (int i = 0; i < a.dimension; ++i) {
        if (glm::length(outside(b, a.axes[i])) > rounding) return false;
    }
    return true;
}

/// The axes of space as far as they lie in it, so that maps along these keep their simple form.
void straighten(AffineHull& hull) {
    if (hull.dimension == 3) hull.axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (hull.dimension == 3) return;
    AffineHull straight{hull.point, 0, {}};
    while (straight.dimension < hull.dimension) {
        glm::dvec3 best{0.0};
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 axis{0.0};
            axis[i] = 1;
            const glm::dvec3 inside = axis - outside(hull, axis);
            const glm::dvec3 rest = outside(straight, inside);
            if (glm::length(rest) > glm::length(best) + rounding) best = rest;
        }
        for (int i = 0; i < 3; ++i) {
            if (std::abs(best[i]) < rounding) best[i] = 0;
        }
        straight.axes[straight.dimension++] = glm::normalize(best);
    }
    hull = straight;
}

bool is_similitude(const Affine& map) {
    const MapKind kind = classify(map);
    return kind == MapKind::homothety || kind == MapKind::similitude;
}

/// The ratio of a map that has entries in the first n axes only and is a similitude of these.
std::optional<double> ratio_within(const glm::dmat3& linear, int n) {
    constexpr double nearly = 1e-12;
    const double square = glm::dot(linear[0], linear[0]);
    if (!(square > 0)) return std::nullopt;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double expected = i == j ? square : 0;
            if (std::abs(glm::dot(linear[i], linear[j]) - expected) > nearly * square) {
                return std::nullopt;
            }
        }
    }
    return std::sqrt(square);
}

/// The axes of the hull and some that complete them.
std::array<glm::dvec3, 3> all_axes(const AffineHull& hull) {
    AffineHull whole = hull;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis{0.0};
        axis[i] = 1;
        add(whole, axis, 0.5);  // of three axes one at least is that far from any line or plane
    }
    return whole.axes;
}

/// A hull grows three times at most; then the images of it are looked at again, those alone. So an
/// edge of the graph is looked at four times at most. How often one was.
std::size_t grow(const Rifs& rifs, std::vector<AffineHull>& hulls) {
    std::vector<std::vector<int>> sets_with(rifs.maps.size());  // per map, where it may stand
    std::vector<std::vector<int>> maps_around(hulls.size());    // per set, the maps it stands in
    std::vector<int> waiting;                                   // sets that have grown
    for (int s = static_cast<int>(hulls.size()); s-- > 0;) {
        waiting.push_back(s);
        for (const int m : rifs.follow_sets[s].maps) sets_with[m].push_back(s);
    }
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        maps_around[rifs.follow_of[m]].push_back(static_cast<int>(m));
    }
    std::vector<char> waits(hulls.size(), 1);
    std::size_t looked_at = 0;
    while (!waiting.empty()) {
        const int inside = waiting.back();
        waiting.pop_back();
        waits[inside] = 0;
        for (const int m : maps_around[inside]) {
            for (const int s : sets_with[m]) {
                ++looked_at;
                if (hulls[s].dimension == 3) continue;
                if (!add_image(hulls[s], rifs.maps[m], hulls[inside])) continue;
                if (!std::exchange(waits[s], char{1})) waiting.push_back(s);
            }
        }
    }
    return looked_at;
}

}  // namespace

std::vector<AffineHull> affine_hulls(const Rifs& rifs) { return search_affine_hulls(rifs).hulls; }

HullSearch search_affine_hulls(const Rifs& rifs) {
    HullSearch result;
    std::vector<AffineHull>& hulls = result.hulls;
    for (const glm::dvec3& point : inner_point_of_each(rifs)) hulls.push_back({point, 0, {}});
    result.edges_looked_at = grow(rifs, hulls);
    std::vector<std::size_t> straight;  // one set for each span
    for (std::size_t s = 0; s < hulls.size(); ++s) {
        const auto same = std::ranges::find_if(
            straight, [&](std::size_t t) { return same_directions(hulls[s], hulls[t]); });
        if (same != straight.end()) {
            hulls[s].axes = hulls[*same].axes;
        } else {
            straighten(hulls[s]);
            straight.push_back(s);
        }
    }
    return result;
}

double stretch_within(const AffineHull& hull, const Affine& map) {
    if (hull.dimension == 0) return 1;
    if (hull.dimension == 3) return std::abs(determinant(map));
    const glm::dvec3 first = map.direction(hull.axes[0]);
    if (hull.dimension == 1) return glm::length(first);
    return glm::length(glm::cross(first, map.direction(hull.axes[1])));
}

std::optional<Rifs> within_hulls(const Rifs& rifs, const std::vector<AffineHull>& hulls) {
    std::vector<const AffineHull*> place(rifs.maps.size(), nullptr);  // where a map stands
    for (std::size_t s = 0; s < hulls.size(); ++s) {
        give_up_if_asked();
        for (const int m : rifs.follow_sets[s].maps) {
            if (place[m] == nullptr) place[m] = &hulls[s];
            if (!same_directions(*place[m], hulls[s])) return std::nullopt;
        }
    }
    Rifs flat = rifs;
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        const AffineHull& inside = hulls[rifs.follow_of[m]];
        flat.maps[m] = {glm::dmat3{0.0}, glm::dvec3{0.0}};
        if (place[m] == nullptr) continue;  // no map of a set: nothing leads to it
        for (int i = 0; i < inside.dimension; ++i) {
            const glm::dvec3 image = rifs.maps[m].direction(inside.axes[i]);
            for (int j = 0; j < place[m]->dimension; ++j) {
                flat.maps[m].linear[i][j] = glm::dot(image, place[m]->axes[j]);
            }
        }
    }
    return flat;
}

Rifs as_similitudes(const Rifs& rifs, const std::vector<AffineHull>& hulls) {
    const auto flat = within_hulls(rifs, hulls);
    if (!flat || std::ranges::all_of(rifs.maps, is_similitude)) return rifs;
    std::vector<const AffineHull*> place(rifs.maps.size(), nullptr);
    for (std::size_t s = 0; s < hulls.size(); ++s) {
        for (const int m : rifs.follow_sets[s].maps) place[m] = &hulls[s];
    }
    Rifs result = rifs;
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        const AffineHull& inside = hulls[rifs.follow_of[m]];
        if (place[m] == nullptr || inside.dimension == 0) return rifs;
        if (inside.dimension != place[m]->dimension) return rifs;
        const auto ratio = ratio_within(flat->maps[m].linear, inside.dimension);
        if (!ratio) return rifs;
        Affine& map = result.maps[m];
        map.linear = glm::dmat3{0.0};
        const auto from = all_axes(inside);
        const auto to = all_axes(*place[m]);
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 image =
                i < inside.dimension ? rifs.maps[m].direction(from[i]) : *ratio * to[i];
            map.linear += glm::outerProduct(image, from[i]);
        }
        map.translation = rifs.maps[m].point(inside.point) - map.linear * inside.point;
    }
    return result;
}

int recurrent_dimension(const Rifs& rifs, const std::vector<AffineHull>& hulls) {
    int dimension = 0;
    for (const std::vector<int>& component : cyclic_components(rifs)) {
        for (const int s : component) dimension = std::max(dimension, hulls[s].dimension);
    }
    return dimension;
}

}  // namespace pxm::host
