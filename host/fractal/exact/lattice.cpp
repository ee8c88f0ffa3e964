#include "host/fractal/exact/lattice.hpp"

#include <flint/fmpq.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pxm::host::exact {

namespace {

using Vector = Lattice::Vector;

/// A whole-number matrix, owned.
class WholeMatrix {
  public:
    WholeMatrix(std::size_t rows, std::size_t columns) {
        give_back_with_thread();
        fmpz_mat_init(value, static_cast<slong>(rows), static_cast<slong>(columns));
    }
    ~WholeMatrix() { fmpz_mat_clear(value); }
    WholeMatrix(const WholeMatrix&) = delete;
    WholeMatrix& operator=(const WholeMatrix&) = delete;

    fmpz_mat_t value;
};

/// As many vectors that span the space, or fewer if there are none.
std::vector<Vector> independent(const ExactSystem& system, const std::vector<Vector>& vectors) {
    const auto n = static_cast<std::size_t>(system.field.dimensions);
    std::vector<Vector> basis;
    for (const Vector& v : vectors) {
        if (basis.size() == n) break;
        basis.push_back(v);
        // Some minor of its rows is not zero.
        bool spans = false;
        std::vector<std::size_t> columns(n);
        for (std::size_t i = 0; i < n; ++i) columns[i] = i;
        std::vector<char> chosen(n, 0);
        std::fill(chosen.begin(), chosen.begin() + static_cast<long>(basis.size()), char{1});
        do {
            std::vector<Vector> minor;
            for (const Vector& row : basis) {
                Vector& kept = minor.emplace_back();
                for (std::size_t c = 0; c < n; ++c)
                    if (chosen[c]) kept.push_back(row[c]);
            }
            spans = spans || !determinant(system, minor).is_zero();
        } while (!spans && std::ranges::prev_permutation(chosen).found);
        if (!spans) basis.pop_back();
    }
    return basis;
}

}  // namespace

/// Rows of whole numbers over one denominator, in coordinates of the basis, of which each begins
/// further right than the one above.
struct Lattice::Inside {
    const ExactSystem& system;
    std::vector<Vector> basis;
    Polynomial volume;  // of the basis: its determinant
    std::vector<std::vector<Polynomial>> rows;
};

namespace {

/// In the basis' coordinates; nothing if one is not rational.
std::optional<Vector> coordinates(const ExactSystem& system, const std::vector<Vector>& basis,
                                  const Polynomial& volume, const Vector& v) {
    const auto lifted = [&](const Polynomial& p) {
        Algebraic a = system.numbers.lifted(whole(0));
        a.value = p;
        return a;
    };
    Vector result;
    for (std::size_t i = 0; i < basis.size(); ++i) {
        std::vector<Vector> rows = basis;
        rows[i] = v;
        const Polynomial share =
            system.numbers.divide(lifted(determinant(system, rows)), lifted(volume)).value;
        if (!share.is_rational()) return std::nullopt;
        result.push_back(share);
    }
    return result;
}

/// Multiples of 1 / denominator that the rows are, in the form of Hermite.
std::vector<Vector> hermite(const std::vector<Vector>& rows, std::size_t n) {
    fmpz_t denominator, factor;
    fmpz_init(denominator);
    fmpz_init(factor);
    fmpz_one(denominator);
    for (const Vector& row : rows)
        for (const Polynomial& p : row)
            fmpz_lcm(denominator, denominator, fmpq_poly_denref(p.get()));
    std::vector<Vector> result;
    {
        WholeMatrix matrix(rows.size(), n);
        for (std::size_t r = 0; r < rows.size(); ++r)
            for (std::size_t c = 0; c < n; ++c) {
                if (rows[r][c].is_zero()) continue;
                fmpz_divexact(factor, denominator, fmpq_poly_denref(rows[r][c].get()));
                fmpz_mul(fmpz_mat_entry(matrix.value, static_cast<slong>(r), static_cast<slong>(c)),
                         factor, fmpq_poly_numref(rows[r][c].get()));
            }
        fmpz_mat_hnf(matrix.value, matrix.value);
        for (std::size_t r = 0; r < std::min(n, rows.size()); ++r) {
            Vector& row = result.emplace_back(n);
            for (std::size_t c = 0; c < n; ++c) {
                fmpq_t entry;
                fmpq_init(entry);
                fmpq_set_fmpz_frac(
                    entry,
                    fmpz_mat_entry(matrix.value, static_cast<slong>(r), static_cast<slong>(c)),
                    denominator);
                fmpq_poly_set_fmpq(row[c].get(), entry);
                fmpq_clear(entry);
            }
        }
    }
    fmpz_clear(denominator);
    fmpz_clear(factor);
    return result;
}

/// quotient, rounded down, of two rationals; and whether it is whole.
std::pair<Polynomial, bool> whole_quotient(const Polynomial& a, const Polynomial& b) {
    fmpq_t x, y;
    fmpq_init(x);
    fmpq_init(y);
    fmpq_poly_get_coeff_fmpq(x, a.get(), 0);
    fmpq_poly_get_coeff_fmpq(y, b.get(), 0);
    fmpq_div(x, x, y);
    const bool is_whole = fmpz_is_one(fmpq_denref(x)) != 0;
    std::pair<Polynomial, bool> result{Polynomial(), is_whole};
    fmpq_poly_set_fmpq(result.first.get(), x);
    fmpq_clear(x);
    fmpq_clear(y);
    return result;
}

}  // namespace

std::optional<Lattice> Lattice::generated(const ExactSystem& system,
                                          const std::vector<Vector>& vectors) {
    constexpr std::size_t most_rows = 64;  // at once
    const auto n = static_cast<std::size_t>(system.field.dimensions);
    auto inside = std::make_shared<Inside>(Inside{system, independent(system, vectors), {}, {}});
    if (inside->basis.size() < n) return std::nullopt;
    inside->volume = determinant(system, inside->basis);
    std::vector<Vector> rows;
    for (const Vector& v : vectors) {
        const auto row = coordinates(system, inside->basis, inside->volume, v);
        if (!row) return std::nullopt;
        rows.push_back(*row);
        if (rows.size() >= most_rows) rows = hermite(rows, n);
    }
    inside->rows = hermite(rows, n);
    return Lattice(std::move(inside));
}

bool Lattice::contains(const Vector& vector) const {
    auto left = coordinates(inside_->system, inside_->basis, inside_->volume, vector);
    if (!left) return false;
    for (std::size_t r = 0; r < inside_->rows.size(); ++r) {
        const auto [times, is_whole] = whole_quotient((*left)[r], inside_->rows[r][r]);
        if (!is_whole) return false;
        for (std::size_t c = r; c < left->size(); ++c)
            (*left)[c] = (*left)[c] - times * inside_->rows[r][c];
    }
    return true;
}

double Lattice::cell() const {
    Algebraic a = inside_->system.numbers.lifted(whole(0));
    a.value = inside_->volume;
    for (std::size_t r = 0; r < inside_->rows.size(); ++r)
        a = inside_->system.numbers.multiply(a, {a.stage, inside_->rows[r][r]});
    return std::abs(inside_->system.numbers.approximate(a));
}

}  // namespace pxm::host::exact
