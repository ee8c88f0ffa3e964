#include "host/math/bracket_matrix.hpp"

#include <cmath>
#include <limits>

#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double largest_entry(const BracketMatrix& matrix) {
    double largest = 0;
    for (const BracketVector& column : matrix.column) {
        for (const Bracket& entry : column) largest = std::max(largest, entry.magnitude());
    }
    return largest;
}

BracketMatrix scaled(BracketMatrix matrix, double factor) {
    for (BracketVector& column : matrix.column) {
        for (Bracket& entry : column) entry = entry * factor;
    }
    return matrix;
}

glm::dmat3 middle(const BracketMatrix& matrix) {
    glm::dmat3 result;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) result[c][r] = matrix[c][static_cast<std::size_t>(r)].middle();
    }
    return result;
}

Bracket dot(const BracketVector& a, const BracketVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// No smaller than the largest row sum of B^T B - shift I, so than its norm.
double gram_at_most(const BracketMatrix& b, double shift) {
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
        Bracket sum;
        for (int j = 0; j < 3; ++j) {
            const Bracket entry = dot(b[i], b[j]) - Bracket{i == j ? shift : 0};
            sum = sum + entry.magnitude();
        }
        largest = std::max(largest, sum.high);
    }
    return largest;
}

}  // namespace

BracketMatrix::BracketMatrix(const glm::dmat3& matrix) {
    for (int c = 0; c < 3; ++c) column[static_cast<std::size_t>(c)] = bracket(matrix[c]);
}

BracketVector bracket(const glm::dvec3& x) { return {x.x, x.y, x.z}; }

BracketVector operator+(const BracketVector& a, const BracketVector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

BracketVector operator-(const BracketVector& a, const BracketVector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

BracketVector operator*(const BracketMatrix& a, const BracketVector& x) {
    BracketVector result;
    for (std::size_t r = 0; r < 3; ++r) {
        result[r] = a[0][r] * x[0] + a[1][r] * x[1] + a[2][r] * x[2];
    }
    return result;
}

BracketMatrix operator*(const BracketMatrix& a, const BracketMatrix& b) {
    BracketMatrix result;
    for (int c = 0; c < 3; ++c) result[c] = a * b[c];
    return result;
}

Bracket length(const BracketVector& x) {
    // Scaled, so that squares neither overflow nor vanish.
    const double largest = std::max({x[0].magnitude(), x[1].magnitude(), x[2].magnitude()});
    if (!(largest > 0)) return {};
    if (!std::isfinite(largest)) return anything();
    const Bracket size{std::exp2(std::clamp(std::ilogb(largest), -1000, 1000))};
    const BracketVector unit{x[0] / size, x[1] / size, x[2] / size};
    return size * sqrt(dot(unit, unit));
}

BracketMatrix inverse_of_lower(const glm::dmat3& lower) {
    // L X = I, forward, one column of X after the other.
    const BracketMatrix l{lower};
    BracketMatrix x;
    for (int c = 0; c < 3; ++c) {
        for (std::size_t r = static_cast<std::size_t>(c); r < 3; ++r) {
            Bracket rest = r == static_cast<std::size_t>(c) ? 1.0 : 0.0;
            for (std::size_t k = 0; k < r; ++k) rest = rest - l.column[k][r] * x[c][k];
            x[c][r] = rest / l.column[r][r];
        }
    }
    return x;
}

double norm_at_most(const BracketMatrix& matrix) {
    const double largest = largest_entry(matrix);
    if (!(largest > 0)) return 0;
    if (!std::isfinite(largest)) return infinity;
    const int exponent = std::clamp(std::ilogb(largest), -1000, 1000);
    const BracketMatrix unit = scaled(matrix, std::ldexp(1.0, -exponent));
    // For any regular V, |M| <= |M V| / (smallest singular value of V). With the right singular
    // vectors, as computed, M V has all but orthogonal columns, and row sums lose nothing.
    const SingularValues values = singular_values(middle(unit));
    const BracketMatrix v{glm::dmat3{values.input[0], values.input[1], values.input[2]}};
    const double gram = gram_at_most(unit * v, 0);
    const double askew = gram_at_most(v, 1);
    const Bracket norm = sqrt(Bracket{gram} / (Bracket{1} - Bracket{askew}));
    if (!(askew < 0.5) || !norm.is_finite()) return infinity;
    return above(std::ldexp(norm.high, exponent));
}

double norm_at_most(const glm::dmat3& matrix) { return norm_at_most(BracketMatrix{matrix}); }

}  // namespace pxm::host
