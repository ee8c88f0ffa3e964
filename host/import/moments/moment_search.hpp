// Maps of a given picture by the method of moments (Sec. 10.1.3): a gradient search with restarts
// for affine maps whose invariant measure has the picture's moments; of all that were found the one
// with the smallest bound by the collage theorem is taken.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "host/import/moments/moments.hpp"

namespace pxm::host {

struct MomentRequest {
    int maps = 4;
    std::uint64_t seed = 1;
    double seconds = 20;
    double finest = 0;                // distance between neighbours of the points, if known
    std::function<bool()> stop = {};  // asked now and then; true ends the search
};

struct MomentResult {
    std::vector<PlaneMap> maps;
    std::vector<double> weights;
    int order = 0;                // of the moments compared
    double residual = 0;          // root mean square of the normalised differences of moments
    double collage_distance = 0;  // h(B, w(B)), Theorem 8.1
    double bound = 0;             // of h(A, B)
    double cell = 0;              // the grid the distances were measured on
    double size = 0;              // the longer side of the picture's box
    long restarts = 0;
    bool out_of_time = false;
};

/// The best maps found in the time. The same seed gives the same maps unless time ran out. Throws
/// Error(ErrorKind::scene) if the points have no extent.
[[nodiscard]] MomentResult search_moments(std::span<const WeightedPoint> points,
                                          const MomentRequest& request);

inline constexpr int most_moment_maps = 16;

}  // namespace pxm::host
