// Maps of the plane as maps of space, the way every reader of plane fractals makes them.
#pragma once

#include "host/math/affine.hpp"

namespace pxm::host {

/// x' = a x + b y + e, y' = c x + d y + f.
struct PlaneNumbers {
    double a = 1;
    double b = 0;
    double c = 0;
    double d = 1;
    double e = 0;
    double f = 0;
};

/// The map that does `first` and then `second`.
[[nodiscard]] PlaneNumbers then(const PlaneNumbers& first, const PlaneNumbers& second);

/// The map in the plane z = 0. It scales z by sqrt |det| of its plane part (a singular map by its
/// largest stretch, a map to a point by 1/2), which no product of maps exceeds in its Lipschitz
/// constant.
[[nodiscard]] Affine plane_map(const PlaneNumbers& numbers);

}  // namespace pxm::host
