#include "host/import/aifs/affine_n.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace pxm::host {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Matrix = Eigen::Map<const RowMatrix>;
using Vector = Eigen::Map<const Eigen::VectorXd>;

Matrix matrix(const AffineN& map) {
    const auto n = static_cast<Eigen::Index>(map.dimension());
    return {map.linear.data(), n, n};
}
Vector offset(const AffineN& map) {
    return {map.offset.data(), static_cast<Eigen::Index>(map.dimension())};
}

AffineN affine(const RowMatrix& linear, const Eigen::VectorXd& offset) {
    return {{linear.data(), linear.data() + linear.size()},
            {offset.data(), offset.data() + offset.size()}};
}

}  // namespace

AffineN scaling_n(std::size_t dimension, double k) {
    AffineN map{std::vector<double>(dimension * dimension, 0), std::vector<double>(dimension, 0)};
    for (std::size_t i = 0; i < dimension; ++i) map.linear[i * dimension + i] = k;
    return map;
}

AffineN compose(const AffineN& outer, const AffineN& inner) {
    const RowMatrix linear = matrix(outer) * matrix(inner);
    const Eigen::VectorXd moved = matrix(outer) * offset(inner) + offset(outer);
    return affine(linear, moved);
}

AffineN plus(const AffineN& a, const AffineN& b, double factor) {
    AffineN sum = a;
    for (std::size_t i = 0; i < sum.linear.size(); ++i) sum.linear[i] += factor * b.linear[i];
    for (std::size_t i = 0; i < sum.offset.size(); ++i) sum.offset[i] += factor * b.offset[i];
    return sum;
}

std::optional<AffineN> inverse(const AffineN& map) {
    const Eigen::PartialPivLU<RowMatrix> parts(matrix(map));
    if (!(std::abs(parts.determinant()) > 0)) return std::nullopt;
    const RowMatrix linear = parts.inverse();
    const Eigen::VectorXd moved = -(linear * offset(map));
    if (!linear.allFinite() || !moved.allFinite()) return std::nullopt;
    return affine(linear, moved);
}

}  // namespace pxm::host
