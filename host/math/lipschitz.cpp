#include "host/math/lipschitz.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "host/math/eigen_matrix.hpp"

namespace pxm::host {

namespace {

constexpr double vanishing = 1e-12;  // of the largest singular value: see classify() and lift()
constexpr double infinity = std::numeric_limits<double>::infinity();

glm::dvec3 column(const Eigen::Matrix3d& matrix, int i) {
    return {matrix(0, i), matrix(1, i), matrix(2, i)};
}

bool vanishes(const SingularValues& singular, int i) {
    const double largest = singular.values[0];
    return singular.values[i] <= vanishing * (largest > 0 ? largest : 1);
}

bool is_uniform_scale(const glm::dmat3& linear, double scale) {
    const glm::dmat3 rest = linear - glm::dmat3{scale};
    return std::max({glm::length(rest[0]), glm::length(rest[1]), glm::length(rest[2])}) <=
           vanishing * scale;
}

}  // namespace

// Of what is not finite, as products of words may be, the values are infinite, infinite and 0:
// bounds that hold whatever it stands for.
SingularValues singular_values(const glm::dmat3& linear) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(eigen_matrix(linear),
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    SingularValues result;
    if (svd.info() != Eigen::Success) {
        result.values = {infinity, infinity, 0};
        for (int i = 0; i < 3; ++i) result.input[i] = result.output[i] = glm::dmat3{1.0}[i];
        return result;
    }
    for (int i = 0; i < 3; ++i) {
        result.values[i] = svd.singularValues()(i);
        result.input[i] = column(svd.matrixV(), i);
        result.output[i] = column(svd.matrixU(), i);
    }
    return result;
}

double smallest_singular_value(const Affine& map) { return singular_values(map.linear).values[2]; }

double lipschitz_constant(const Affine& map) {
    // Sec. 16.2: the largest eigenvalue of S, T = S Q, is the largest singular value.
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(eigen_matrix(map.linear));
    return svd.info() == Eigen::Success ? svd.singularValues()(0) : infinity;
}

double determinant_constant(const Affine& map) {
    return std::cbrt(std::abs(determinant(map)));  // Eq. 16.3, Erratum 6
}

MapKind classify(const Affine& map) {
    const SingularValues singular = singular_values(map.linear);
    if (vanishes(singular, 2)) return MapKind::singular;
    const double largest = singular.values[0];
    if (singular.values[2] < (1 - vanishing) * largest) return MapKind::affine;
    return is_uniform_scale(map.linear, largest) ? MapKind::homothety : MapKind::similitude;
}

Affine lift(const Affine& map, double thickness) {
    const SingularValues singular = singular_values(map.linear);
    Affine lifted = map;
    for (int i = 0; i < 3; ++i) {
        if (!vanishes(singular, i)) continue;
        const double raise = std::max(thickness - singular.values[i], 0.0);
        lifted.linear += raise * glm::outerProduct(singular.output[i], singular.input[i]);
    }
    return lifted;
}

}  // namespace pxm::host
