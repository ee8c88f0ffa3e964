#include "tests/support/enumeration.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <random>

#include "host/math/lipschitz.hpp"

namespace pxm::test {

using namespace host;

namespace {

constexpr double finest = 0.25;   // pixels
constexpr int ball_rounds = 400;  // fixed-point iterations: 0.9^400 is 5e-19
constexpr int word_length = 200;  // of a random word

/// An upper bound of the largest singular value, cheaper than the value.
double norm_bound(const glm::dmat3& t) {
    double rows = 0;
    double columns = 0;
    double squares = 0;
    for (int i = 0; i < 3; ++i) {
        rows = std::max(rows, std::abs(t[i].x) + std::abs(t[i].y) + std::abs(t[i].z));
        columns = std::max(columns, std::abs(t[0][i]) + std::abs(t[1][i]) + std::abs(t[2][i]));
        squares += glm::dot(t[i], t[i]);
    }
    return std::sqrt(std::min(squares, rows * columns));
}

}  // namespace

std::optional<ImagePlace> project(const CompiledCamera& camera, const glm::dvec3& point) {
    // point = u across + v down + w (corner or forward); glm's matrix columns are these three.
    const bool orthographic = camera.projection == kernels::Projection::orthographic;
    const glm::dmat3 basis{camera.across, camera.down,
                           orthographic ? camera.forward : camera.corner};
    const glm::dvec3 offset = orthographic ? point - camera.corner : point;
    const glm::dvec3 uvw = glm::inverse(basis) * offset;
    if (orthographic) return ImagePlace{uvw.x, uvw.y};
    if (uvw.z <= 0) return std::nullopt;
    return ImagePlace{uvw.x / uvw.z, uvw.y / uvw.z};
}

Enumeration::Enumeration(const CompiledScene& scene)
    : scene_(scene), pixels_(static_cast<std::size_t>(scene.size.columns * scene.size.rows)) {
    for (const CompiledShape& shape : scene.shapes) balls_.push_back(balls_of(shape));
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const CompiledObject& object = scene.objects[i];
        subdivide(static_cast<int>(i), object.instance, lipschitz_constant(object.instance),
                  object.start);
    }
}

const std::vector<AttractorPoint>& Enumeration::at(long x, long y) const {
    if (x < 0 || y < 0 || x >= scene_.size.columns || y >= scene_.size.rows) return nothing_;
    return pixels_[static_cast<std::size_t>(y * scene_.size.columns + x)];
}

double Enumeration::distance(const glm::dvec3& place, long x, long y, long reach) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (long row = y - reach; row <= y + reach; ++row) {
        for (long column = x - reach; column <= x + reach; ++column) {
            for (const AttractorPoint& point : at(column, row)) {
                nearest = std::min(nearest, glm::distance(place, point.place));
            }
        }
    }
    return nearest;
}

void Enumeration::subdivide(int object, const Affine& place, double lip, int set) {
    const auto shape_index =
        static_cast<std::size_t>(scene_.objects[static_cast<std::size_t>(object)].shape);
    const Ball& ball = balls_[shape_index][static_cast<std::size_t>(set)];
    const glm::dvec3 center = place.point(ball.center);
    const double radius = std::min(lip, norm_bound(place.linear)) * ball.radius;
    if (2 * radius <= finest * pixel_size(center)) {
        const auto image = project(scene_.camera, center);
        if (!image) return;
        const auto x = static_cast<long>(std::floor(image->x));
        const auto y = static_cast<long>(std::floor(image->y));
        if (x < 0 || y < 0 || x >= scene_.size.columns || y >= scene_.size.rows) return;
        const bool orthographic = scene_.camera.projection == kernels::Projection::orthographic;
        const double depth =
            orthographic ? glm::dot(center, scene_.camera.forward) : glm::length(center);
        pixels_[static_cast<std::size_t>(y * scene_.size.columns + x)].push_back(
            {center, depth, object});
        ++points_;
        return;
    }
    const CompiledShape& shape = scene_.shapes[shape_index];
    for (const int m : shape.sets[static_cast<std::size_t>(set)].maps) {
        const CompiledMap& map = shape.maps[static_cast<std::size_t>(m)];
        subdivide(object, then(map.map, place), lip * lipschitz_constant(map.map), map.follow_set);
    }
}

double Enumeration::pixel_size(const glm::dvec3& place) const {
    return scene_.camera.pixel_at_eye + scene_.camera.pixel_growth * glm::length(place);
}

std::vector<Enumeration::Ball> Enumeration::balls_of(const CompiledShape& shape) {
    // Centres: c_s = mean of w_m(c_follow(m)). Radii: the smallest r with
    // |w_m(c_follow(m)) - c_s| + Lip w_m r_follow(m) <= r_s for all m in s, from below.
    std::vector<Ball> balls(shape.sets.size());
    for (int round = 0; round < 2 * ball_rounds; ++round) {
        std::vector<Ball> next(balls.size());
        for (std::size_t s = 0; s < balls.size(); ++s) {
            const std::vector<int>& maps = shape.sets[s].maps;
            if (round >= ball_rounds) next[s].center = balls[s].center;
            for (const int m : maps) {
                const CompiledMap& map = shape.maps[static_cast<std::size_t>(m)];
                const Ball& inner = balls[static_cast<std::size_t>(map.follow_set)];
                const glm::dvec3 image = map.map.point(inner.center);
                if (round < ball_rounds) {
                    next[s].center += image / static_cast<double>(maps.size());
                } else {
                    next[s].radius =
                        std::max(next[s].radius, glm::distance(image, balls[s].center) +
                                                     lipschitz_constant(map.map) * inner.radius);
                }
            }
        }
        balls = next;
    }
    return balls;
}

std::vector<glm::dvec3> random_points(const CompiledScene& scene, int object, int count,
                                      unsigned seed) {
    const CompiledObject& instance = scene.objects[static_cast<std::size_t>(object)];
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(instance.shape)];
    std::mt19937 random(seed);
    std::vector<glm::dvec3> points;
    for (int i = 0; i < count; ++i) {
        Affine place = instance.instance;
        int set = instance.start;
        for (int level = 0; level < word_length; ++level) {
            const std::vector<int>& maps = shape.sets[static_cast<std::size_t>(set)].maps;
            const int m = maps[random() % maps.size()];
            place = then(shape.maps[static_cast<std::size_t>(m)].map, place);
            set = shape.maps[static_cast<std::size_t>(m)].follow_set;
        }
        points.push_back(place.translation);  // the image of any point: the map is constant by now
    }
    return points;
}

}  // namespace pxm::test
