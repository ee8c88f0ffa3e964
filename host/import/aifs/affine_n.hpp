// Affine maps of n dimensions.
#pragma once

#include <memory>
#include <optional>
#include <vector>

namespace pxm::host {

/// x' = linear x + offset, the matrix by rows.
struct AffineN {
    std::vector<double> linear;
    std::vector<double> offset;

    [[nodiscard]] std::size_t dimension() const { return offset.size(); }
};

/// The multiple k of the identity.
[[nodiscard]] AffineN scaling_n(std::size_t dimension, double k);
/// x -> outer(inner(x)).
[[nodiscard]] AffineN compose(const AffineN& outer, const AffineN& inner);
/// a + factor b, point by point.
[[nodiscard]] AffineN plus(const AffineN& a, const AffineN& b, double factor);
/// Nothing if the matrix is singular, or so nearly that its inverse is not finite.
[[nodiscard]] std::optional<AffineN> inverse(const AffineN& map);

}  // namespace pxm::host
