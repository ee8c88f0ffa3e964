// Bounds against points of attractors in 77 digits, without a margin: whatever rounding takes from
// a bound must have been carried with it. The quick and full tests take ever larger shares of the
// systems.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "host/fractal/bounds/farthest.hpp"
#include "host/fractal/bounds/polytope.hpp"
#include "host/fractal/bounds/support.hpp"
#include "tests/host/fractal/proof_campaign.hpp"

namespace pxm::host::sure_bounds {

using proof_campaign::Numbers;
using proof_campaign::Real;
using proof_campaign::RealVector;

/// Homotheties and quarter turns, whose reaches are those of points that stand still; any
/// similitudes; affine maps; a far place, where numbers keep few digits of the size; and systems
/// around the border.
inline Rifs system(unsigned seed) {
    constexpr unsigned kinds = 5;
    if (seed % kinds == kinds - 1) return proof_campaign::border_system(seed);
    Numbers numbers(seed);
    const double far = seed % kinds == 3 ? numbers.any_size(7) : 1;
    std::vector<Affine> maps;
    const int count = 2 + numbers.below(3);
    for (int i = 0; i < count; ++i) {
        Affine map = scaling(glm::dvec3{numbers.between(0.2, 0.7)});
        if (seed % kinds > 0) {
            map = then(map, rotation(Axis::z, seed % 2 == 0 ? 90 : numbers.between(-180, 180)));
        }
        if (seed % kinds == 2) map.linear[0][1] += numbers.between(-0.2, 0.2);
        const glm::dvec3 place{numbers.between(-1, 1), numbers.between(-1, 1),
                               numbers.between(-1, 1)};
        // About a place far away, if that is where they are.
        const Affine away = translation(glm::dvec3{far, -far, far / 3});
        maps.push_back(then(then(inverse(away), then(map, translation(place))), away));
    }
    return systems::complete(maps);
}

/// Points of E_set, each where a cycle of at most three maps stands still.
inline std::vector<RealVector> points_of(const Rifs& rifs, int set) {
    std::vector<RealVector> points;
    proof_campaign::for_each_cycle(rifs, 3, [&](int s, const proof_campaign::RealWord& word) {
        if (s != set) return;
        points.push_back(proof_campaign::fixed_point(word.linear, word.translation));
    });
    return points;
}

inline Real dot(const glm::dvec3& u, const RealVector& x) {
    return Real{u.x} * x[0] + Real{u.y} * x[1] + Real{u.z} * x[2];
}

struct Tried {
    int systems = 0;
    int reaches = 0;
    int short_without_rounding = 0;  // reaches as computed that a point passes
};

/// Law: no point passes the reach, nor is any farther away than the farthest.
inline void reaches_hold(const Rifs& rifs, const Approximation& known, int set, Numbers& numbers,
                         const std::vector<RealVector>& points, Tried& tried) {
    constexpr long budget = 300;
    for (int i = 0; i < 4; ++i) {
        glm::dvec3 u{numbers.between(-1, 1), numbers.between(-1, 1), numbers.between(-1, 1)};
        if (i < 2) u = glm::dvec3{0.0, i == 0 ? 1 : -1, 0.0};
        const Reach found = reach(rifs, known, set, u, 0, budget);
        const Reach away = farthest(rifs, known, set, u, {0, 0, 0, budget});
        bool passed = false;
        for (const RealVector& x : points) {
            const Real along = dot(u, x);
            ASSERT_TRUE(along <= found.at_most());
            passed = passed || along > found.upper;
            Real square = 0;
            for (int k = 0; k < 3; ++k) square += (x[k] - u[k]) * (x[k] - u[k]);
            ASSERT_TRUE(square <= Real{away.at_most()} * away.at_most());
        }
        ++tried.reaches;
        tried.short_without_rounding += passed ? 1 : 0;
    }
}

/// Law: convex volumes of each kind hold the points.
inline void volumes_hold(const Rifs& rifs, const Approximation& known, int set,
                         const std::vector<RealVector>& points) {
    const Polytope sides = polytope(rifs, known, set);
    const OrientedBox box = oriented_box(rifs, known, set);
    for (const RealVector& x : points) {
        for (const HalfSpace& side : sides) ASSERT_TRUE(dot(side.normal, x) <= side.offset);
        // The point in the coordinates of the box, by Cramer's rule.
        proof_campaign::RealMatrix left;
        RealVector from;
        for (int i = 0; i < 3; ++i) {
            from[static_cast<std::size_t>(i)] = x[static_cast<std::size_t>(i)] - box.center[i];
            const glm::dvec3& half = box.half[static_cast<std::size_t>(i)];
            for (int k = 0; k < 3; ++k) {
                left[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
                    (i == k ? 1 : 0) - Real{half[k]};
            }
        }
        for (const Real& t : proof_campaign::fixed_point(left, from)) ASSERT_TRUE(abs(t) <= 1);
    }
}

inline Tried try_systems(unsigned first, unsigned last) {
    constexpr long words = 2'000;
    Tried tried;
    for (unsigned seed = first; seed < last; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Rifs rifs = system(seed);
        const Contraction proof = prove_contraction(rifs, words);
        if (proof.proof == ContractionProof::none || proof.rate > 0.9) continue;
        const std::vector<Bounds> bounds = bound(rifs, proof);
        const Approximation known = approximation(rifs, bounds);
        Numbers numbers(seed + 1);
        const std::vector<RealVector> points = points_of(rifs, rifs.start);
        ++tried.systems;
        proof_campaign::volumes_contain(rifs, bounds, 3);
        reaches_hold(rifs, known, rifs.start, numbers, points, tried);
        // What is bounded by infinity alone has no other volume.
        if (std::isfinite(bounds[static_cast<std::size_t>(rifs.start)].ball.radius)) {
            volumes_hold(rifs, known, rifs.start, points);
        }
        if (testing::Test::HasFatalFailure()) break;
    }
    return tried;
}

}  // namespace pxm::host::sure_bounds
