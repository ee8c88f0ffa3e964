// The systems of the campaigns and their laws: 2 to 50 maps of the plane or of space, affine, with
// and without a graph, some singular, some that barely contract. The slow tests take a share of
// them, the full tests thousands.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/dimension/default_weights.hpp"
#include "host/fractal/measure/chaos_game.hpp"
#include "host/math/lipschitz.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host::campaign {

enum class Space { plane, solid };

/// A random affine map with singular values up to `largest`; every eighth is singular.
inline Affine random_map(std::mt19937_64& random, double largest, Space space) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const bool singular = random() % 8 == 0;
    const double squash = singular ? 0 : unit(random);
    const auto offset = [&] { return unit(random); };
    if (space == Space::plane) {
        return systems::map({rotation(Axis::z, 180 * unit(random)),
                             scaling({largest, largest * squash, largest * std::abs(squash)}),
                             rotation(Axis::z, 180 * unit(random)),
                             translation({offset(), offset(), 0})});
    }
    const auto turn = [&](Axis axis) { return rotation(axis, 180 * unit(random)); };
    return systems::map({turn(Axis::x), turn(Axis::y), turn(Axis::z),
                         scaling({largest * unit(random), largest * squash, largest}),
                         turn(Axis::x), turn(Axis::y), turn(Axis::z),
                         translation({offset(), offset(), offset()})});
}

/// The contraction of a system's least contracting map: every twelfth system barely contracts.
inline double largest_of(unsigned seed) {
    constexpr double slow[] = {0.96, 0.98, 0.99, 0.995};
    return seed % 12 == 0 ? slow[seed / 12 % 4] : 0.2 + 0.01 * (seed % 71);
}

/// System `seed` of the campaign: every second in the plane, every third with a graph.
inline Rifs random_system(unsigned seed) {
    std::mt19937_64 random(seed);
    const int count = 2 + static_cast<int>(random() % (seed % 4 == 0 ? 49 : 9));
    const Space space = seed % 2 == 0 ? Space::plane : Space::solid;
    const double largest = largest_of(seed);
    std::vector<Affine> maps{random_map(random, largest, space)};
    std::uniform_real_distribution<double> share(0.2, 1);
    while (static_cast<int>(maps.size()) < count)
        maps.push_back(random_map(random, largest * share(random), space));
    if (seed % 3 != 0) return systems::complete(maps);
    std::vector<std::vector<int>> follow(maps.size());
    const unsigned sparseness = 1 + seed / 3 % 4;
    for (std::vector<int>& of_map : follow) {
        for (int j = 0; j < count; ++j) {
            if (random() % (1 + sparseness) == 0) of_map.push_back(j);
        }
        if (of_map.empty()) of_map.push_back(static_cast<int>(random() % maps.size()));
    }
    return systems::with_graph(maps, follow);
}

/// Law: random points of every follow set lie in its ball and box. `depth` maps deep, so that what
/// stands inside no longer matters.
inline void bounds_contain(unsigned seed) {
    const Rifs rifs = random_system(seed);
    const Contraction contraction = prove_contraction(rifs);
    ASSERT_NE(contraction.proof, ContractionProof::none) << "seed " << seed;
    const std::vector<Bounds> bounds = bound(rifs, contraction);
    const int depth = std::min(6000, static_cast<int>(-34 / std::log(largest_of(seed))) + 1);
    std::mt19937_64 random(seed + 1);
    const int points = depth > 500 ? 20 : 100;
    for (std::size_t s = 0; s < bounds.size(); s += bounds.size() / 8 + 1) {
        const auto& [ball, box, slack] = bounds[s];
        for (int i = 0; i < points; ++i) {
            const glm::dvec3 x = systems::random_point(rifs, static_cast<int>(s), depth, random);
            ASSERT_LE(glm::distance(x, ball.center), ball.radius) << "seed " << seed;
            for (int k = 0; k < 3; ++k) {
                ASSERT_GE(x[k], box.low[k]) << "seed " << seed;
                ASSERT_LE(x[k], box.high[k]) << "seed " << seed;
            }
        }
    }
}

/// Whether a point belongs to a system's attractor, by a search for a word whose cells hold it.
class Membership {
  public:
    enum class Answer { on, off, unknown };

    Membership(const Rifs& rifs, const std::vector<Bounds>& bounds, double tolerance)
        : rifs_(rifs), bounds_(bounds), tolerance_(tolerance) {}

    /// Is there a cell no larger than the tolerance that holds x to within the tolerance?
    Answer of(const glm::dvec3& x) {
        steps_ = 0;
        return search({}, rifs_.start, x);
    }

  private:
    static constexpr int step_limit = 100'000;
    struct Child {
        Affine place;
        int set;
        double order;  // distance of x in radii of the cell: nearest first
    };

    Answer search(const Affine& place, int set, const glm::dvec3& x) {
        if (++steps_ > step_limit) return Answer::unknown;
        const Ball& ball = bounds_[static_cast<std::size_t>(set)].ball;
        if (lipschitz_constant(place) * ball.radius <= tolerance_) return Answer::on;
        std::vector<Child> children;
        for (const int m : rifs_.follow_sets[static_cast<std::size_t>(set)].maps)
            consider(then(rifs_.maps[static_cast<std::size_t>(m)], place),
                     rifs_.follow_of[static_cast<std::size_t>(m)], x, children);
        std::ranges::sort(children, {}, &Child::order);
        for (const Child& child : children) {
            const Answer answer = search(child.place, child.set, x);
            if (answer != Answer::off) return answer;
        }
        return Answer::off;
    }

    /// Keeps a cell if x lies in the box around the image of its ball.
    void consider(const Affine& place, int set, const glm::dvec3& x, std::vector<Child>& kept) {
        const Ball& ball = bounds_[static_cast<std::size_t>(set)].ball;
        const glm::dvec3 apart = x - place.point(ball.center);
        double order = 0;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 row{place.linear[0][k], place.linear[1][k], place.linear[2][k]};
            const double reach = ball.radius * glm::length(row) + tolerance_;
            if (std::abs(apart[k]) > reach) return;
            order = std::max(order, std::abs(apart[k]) / reach);
        }
        kept.push_back({place, set, order});
    }

    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    double tolerance_;
    int steps_ = 0;
};

struct Tried {
    int points = 0;
    int unknown = 0;
};

/// Law: the chaos game's points lie on the attractor, to a millionth of its size. Where words get
/// so long that the search would not end, in its ball alone.
inline Tried points_lie_on_the_attractor(unsigned seed, int points) {
    const Rifs rifs = random_system(seed);
    const Contraction contraction = prove_contraction(rifs);
    const std::vector<Bounds> bounds = bound(rifs, contraction);
    const Ball& all = bounds[static_cast<std::size_t>(rifs.start)].ball;
    const double tolerance = 1e-6 * all.radius;
    ChaosGame game(rifs, default_weights(rifs), std::vector<glm::dvec4>(rifs.maps.size()), seed);
    Membership membership(rifs, bounds, tolerance);
    Tried tried;
    for (int i = 0; i < points; ++i) {
        const glm::dvec3 x = game.next().place;
        EXPECT_LE(glm::distance(x, all.center), all.radius + tolerance) << "seed " << seed;
        if (largest_of(seed) > 0.8) continue;
        const auto answer = membership.of(x);
        EXPECT_NE(answer, Membership::Answer::off) << "seed " << seed;
        ++tried.points;
        tried.unknown += answer == Membership::Answer::unknown;
    }
    return tried;
}

}  // namespace pxm::host::campaign
