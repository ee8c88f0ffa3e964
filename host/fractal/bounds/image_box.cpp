#include "host/fractal/bounds/image_box.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

constexpr long work_limit = 5'000'000;  // images taken
constexpr long most_rounds = 400;
constexpr double settled = 1e-8;    // of a box's size: changes below are not worth a round
constexpr double rounding = 1e-14;  // of the coordinates
constexpr double infinity = std::numeric_limits<double>::infinity();

double sum(const glm::dvec3& v) { return v.x + v.y + v.z; }

/// The box of map(E), E in both the ball and the box.
Box image(const Affine& map, const Bounds& bounds) {
    const glm::dvec3 middle = map.point((bounds.box.low + bounds.box.high) / 2.0);
    const glm::dvec3 center = map.point(bounds.ball.center);
    const glm::dvec3 half = (bounds.box.high - bounds.box.low) / 2.0;
    const glm::dmat3 rows = glm::transpose(map.linear);
    Box box;
    for (int i = 0; i < 3; ++i) {
        const double of_box = sum(glm::abs(rows[i]) * half);
        const double of_ball = glm::length(rows[i]) * bounds.ball.radius;
        const double slack = rounding * (std::abs(middle[i]) + of_box);
        box.low[i] = std::max(middle[i] - of_box, center[i] - of_ball) - slack;
        box.high[i] = std::min(middle[i] + of_box, center[i] + of_ball) + slack;
    }
    return box;
}

/// The same from the sure box, outward: what rounding may have taken from it is added.
Box sure_image(const Affine& map, const Box& inside, const Ball& ball, double shortfall) {
    const glm::dvec3 low = inside.low / 2.0;
    const glm::dvec3 high = inside.high / 2.0;
    const glm::dvec3 middle = map.point(low + high);
    const glm::dvec3 center = map.point(ball.center);
    const glm::dvec3 half = high - low;
    const glm::dmat3 rows = glm::transpose(map.linear);
    const glm::dvec3 of_box = terms_of(map.linear, half, glm::dvec3{0.0});
    const glm::dvec3 box_terms =
        terms_of(map.linear, 2.0 * (glm::abs(low) + glm::abs(high)), map.translation);
    const glm::dvec3 ball_terms =
        terms_of(map.linear, glm::abs(ball.center) + ball.radius, map.translation);
    Box box;
    for (int i = 0; i < 3; ++i) {
        const double reach = of_box[i] + rounding_of(box_terms[i]);
        const double of_ball = glm::length(rows[i]) * (ball.radius + shortfall) +
                               rounding_of(ball_terms[i] + sum_of_parts(rows[i]) * shortfall);
        const double low_end = std::max(below(middle[i] - reach), below(center[i] - of_ball));
        const double high_end = std::min(above(middle[i] + reach), above(center[i] + of_ball));
        // What double cannot hold is no bound.
        box.low[i] = std::isnan(low_end) ? -infinity : low_end;
        box.high[i] = std::isnan(high_end) ? infinity : high_end;
    }
    return box;
}

constexpr Box nothing() { return {glm::dvec3{infinity}, glm::dvec3{-infinity}}; }

void add(Box& all, const Box& box) {
    all.low = glm::min(all.low, box.low);
    all.high = glm::max(all.high, box.high);
}

/// Shrinks one box and returns by how much, as a share of its size.
double shrink(const Rifs& rifs, Approximation& known, std::size_t set) {
    Box images = nothing();
    Box sure_images = nothing();
    for (const int m : rifs.follow_sets[set].maps) {
        const auto inside = static_cast<std::size_t>(rifs.follow_of[m]);
        const Bounds& bounds = known.outer[inside];
        add(images, image(rifs.maps[m], bounds));
        add(sure_images, sure_image(rifs.maps[m], known.sure[inside], bounds.ball,
                                    known.shortfall[inside].ball));
    }
    Box& box = known.outer[set].box;
    const Box before = box;
    box.low = glm::max(box.low, images.low);
    box.high = glm::min(box.high, images.high);
    Box& sure = known.sure[set];
    sure.low = glm::max(sure.low, sure_images.low);
    sure.high = glm::min(sure.high, sure_images.high);
    known.shortfall[set].box = shortfall_of_box(box, sure);
    const double moved = sum(box.low - before.low) + sum(before.high - box.high);
    return moved / sum(before.high - before.low);
}

}  // namespace

void shrink_boxes(const Rifs& rifs, Approximation& known) {
    long edges = 1;
    for (const FollowSet& set : rifs.follow_sets) edges += static_cast<long>(set.maps.size());
    for (long round = std::clamp<long>(work_limit / edges, 2, most_rounds); round > 0; --round) {
        double largest = 0;
        for (std::size_t s = 0; s < known.outer.size(); ++s) {
            give_up_if_asked();
            largest = std::max(largest, shrink(rifs, known, s));
        }
        if (!(largest > settled)) return;
    }
}

double shortfall_of_box(const Box& box, const Box& sure) {
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        most = std::max({most, above(box.low[i] - sure.low[i]), above(sure.high[i] - box.high[i])});
    }
    return most;
}

}  // namespace pxm::host
