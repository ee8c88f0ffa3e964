// What the peers are given: the cells of k levels as one geometry, and the list of upper cells that
// it is instanced by, chosen for one eye so that what is drawn is just below a pixel. Only for one
// object of homotheties of one ratio, with all maps allowed everywhere.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/described.hpp"

namespace bench {

inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// The object's shape, if the peers can take it.
inline const Shape& only_shape(const Scene& scene) {
    if (scene.objects.size() != 1 || scene.parallel) {
        throw std::runtime_error("the peers take one object and a perspective view");
    }
    const Shape& shape = scene.shapes[static_cast<std::size_t>(scene.objects[0].shape)];
    for (const Map& map : shape.maps) {
        if (!shape.similar || map.constant != shape.maps[0].constant || shape.sets.size() != 1) {
            throw std::runtime_error("the peers take maps that are homotheties of one ratio");
        }
    }
    return shape;
}

/// The places of all cells of `levels` levels under `from`.
inline std::vector<Affine> cells_of_level(const Shape& shape, const Affine& from, int levels) {
    std::vector<Affine> cells{from};
    for (; levels > 0; --levels) {
        std::vector<Affine> next;
        next.reserve(cells.size() * shape.maps.size());
        for (const Affine& cell : cells) {
            for (const Map& map : shape.maps) next.push_back(compose(map.map, cell));
        }
        cells = std::move(next);
    }
    return cells;
}

/// Half-spaces through the eye that hold the picture: dot(plane, x) >= 0.
inline std::array<Vec3, 4> frustum(const Scene& scene) {
    const Vec3 a = scene.corner;
    const Vec3 b = a + scene.columns * scene.across;
    const Vec3 d = a + scene.rows * scene.down;
    const Vec3 c = b + scene.rows * scene.down;
    const Vec3 middle = 0.25 * (a + b + c + d);
    std::array<Vec3, 4> planes{cross(a, b), cross(b, c), cross(c, d), cross(d, a)};
    for (Vec3& plane : planes) {
        plane = (dot(plane, middle) < 0 ? -1 : 1) / length(plane) * plane;
    }
    return planes;
}

/// The largest cells in view whose k levels end at or below a pixel of their nearest point.
class UpperCells {
  public:
    UpperCells(const Scene& scene, int levels, std::size_t most)
        : scene_(scene), shape_(only_shape(scene)), planes_(frustum(scene)), most_(most) {
        shrink_ = std::pow(shape_.maps[0].constant, levels);
        descend(scene.objects[0].instance, scene.objects[0].constant);
    }
    [[nodiscard]] std::vector<Affine> take() { return std::move(cells_); }

  private:
    void descend(const Affine& place, double constant) {
        const FollowSet& set = shape_.sets[0];
        const Vec3 center = transform_point(set.center, place);
        const double radius = constant * set.radius;
        for (const Vec3& plane : planes_) {
            if (dot(plane, center) < -radius) return;
        }
        const double nearest = std::max(length(center) - radius, 0.0);
        const double p = std::max(scene_.pixel_growth * nearest, 0x1p-30);
        if (constant * set.diameter * shrink_ <= scene_.detail * p) {
            if (cells_.size() == most_) throw std::runtime_error("too many instances");
            cells_.push_back(place);
            return;
        }
        for (const Map& map : shape_.maps) {
            descend(compose(map.map, place), constant * map.constant);
        }
    }

    const Scene& scene_;
    const Shape& shape_;
    std::array<Vec3, 4> planes_;
    double shrink_ = 1;
    std::size_t most_;
    std::vector<Affine> cells_;
};

/// The fixed point of a homothety.
inline Vec3 fixed_point(const Map& map) { return (1 / (1 - map.constant)) * map.map.row[3]; }

using Triangle = std::array<Vec3, 3>;

/// The faces of the hull of a system's fixed points, which is the hull of its attractor, as fans.
inline std::vector<Triangle> hull_faces(const Shape& shape) {
    std::vector<Vec3> points;
    for (const Map& map : shape.maps) points.push_back(fixed_point(map));
    constexpr double slack = 1e-6;
    std::vector<Triangle> faces;
    std::vector<Vec3> normals;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < points.size(); ++j) {
            for (std::size_t k = 0; k < points.size(); ++k) {
                Vec3 n = cross(points[j] - points[i], points[k] - points[i]);
                if (length(n) < slack) continue;
                n = (1 / length(n)) * n;
                const double at = dot(n, points[i]);
                std::vector<Vec3> on;
                Vec3 middle{};
                bool outside = false;
                for (const Vec3& point : points) {
                    outside = outside || dot(n, point) > at + slack;
                    if (std::abs(dot(n, point) - at) > slack) continue;
                    on.push_back(point);
                    middle = middle + point;
                }
                const auto known = [&](const Vec3& m) { return dot(m, n) > 1 - slack; };
                if (outside || std::any_of(normals.begin(), normals.end(), known)) continue;
                normals.push_back(n);
                middle = (1 / static_cast<double>(on.size())) * middle;
                const Vec3 x = on[0] - middle;
                const Vec3 y = cross(n, x);
                std::sort(on.begin(), on.end(), [&](const Vec3& a, const Vec3& b) {
                    return std::atan2(dot(a - middle, y), dot(a - middle, x)) <
                           std::atan2(dot(b - middle, y), dot(b - middle, x));
                });
                // Points inside an edge (the sponge's) would only split faces.
                std::vector<Vec3> corners;
                for (std::size_t m = 0; m < on.size(); ++m) {
                    const Vec3& before = on[(m + on.size() - 1) % on.size()];
                    const Vec3& after = on[(m + 1) % on.size()];
                    if (length(cross(on[m] - before, after - on[m])) > slack) {
                        corners.push_back(on[m]);
                    }
                }
                for (std::size_t m = 1; m + 1 < corners.size(); ++m) {
                    faces.push_back({corners[0], corners[m], corners[m + 1]});
                }
            }
        }
    }
    return faces;
}

}  // namespace bench
