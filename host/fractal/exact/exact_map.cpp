#include "host/fractal/exact/exact_map.hpp"

#include <flint/fmpq.h>
#include <flint/fmpz_vec.h>

#include <algorithm>
#include <cmath>

namespace pxm::host::exact {

namespace {

std::size_t entries_of(const FieldFacts& field) {
    return static_cast<std::size_t>(field.dimensions) *
           (static_cast<std::size_t>(field.dimensions) + 1);
}

/// Polynomials of twice the field's degree, before they are reduced.
class Sum {
  public:
    explicit Sum(int degree) : words_(2 * static_cast<std::size_t>(degree) - 1, 0) {}
    Sum(const Sum&) = delete;
    Sum& operator=(const Sum&) = delete;
    ~Sum() {
        for (fmpz& w : words_) fmpz_clear(&w);
    }
    void clear() {
        for (fmpz& w : words_) fmpz_zero(&w);
    }
    void add(const fmpz* a, const fmpz* b, std::size_t degree) {
        for (std::size_t i = 0; i < degree; ++i) {
            if (fmpz_is_zero(a + i) != 0) continue;
            for (std::size_t k = 0; k < degree; ++k) fmpz_addmul(&words_[i + k], a + i, b + k);
        }
    }
    /// Modulo the field's polynomial, to `to`.
    void take(const FieldFacts& field, fmpz* to) {
        const auto degree = static_cast<std::size_t>(field.degree);
        for (std::size_t i = words_.size(); i-- > degree;) {
            for (std::size_t k = 0; k < degree; ++k) {
                const long c = field.modulus[k];
                fmpz* target = &words_[i - degree + k];
                if (c >= 0) {
                    fmpz_submul_ui(target, &words_[i], static_cast<ulong>(c));
                } else {
                    fmpz_addmul_ui(target, &words_[i], static_cast<ulong>(-c));
                }
            }
        }
        for (std::size_t k = 0; k < degree; ++k) fmpz_swap(to + k, &words_[k]);
    }

  private:
    std::vector<fmpz> words_;
};

}  // namespace

ExactMap::ExactMap(const FieldFacts& field, const std::vector<Polynomial>& entries)
    : ExactMap(entries_of(field) * static_cast<std::size_t>(field.degree) + 1) {
    fmpz* denominator = &words_.back();
    fmpz_one(denominator);
    for (const Polynomial& p : entries)
        fmpz_lcm(denominator, denominator, fmpq_poly_denref(p.get()));
    fmpz_t factor;
    fmpz_init(factor);
    const auto degree = static_cast<std::size_t>(field.degree);
    for (std::size_t e = 0; e < entries.size(); ++e) {
        const fmpq_poly_struct* p = entries[e].get();
        fmpz_divexact(factor, denominator, fmpq_poly_denref(p));
        for (std::size_t i = 0; i < static_cast<std::size_t>(fmpq_poly_length(p)); ++i)
            fmpz_mul(&words_[e * degree + i], fmpq_poly_numref(p) + i, factor);
    }
    fmpz_clear(factor);
    reduce();
}

ExactMap ExactMap::identity(const FieldFacts& field) {
    const std::size_t n = static_cast<std::size_t>(field.dimensions);
    std::vector<Polynomial> entries(entries_of(field));
    for (std::size_t i = 0; i < n; ++i) entries[i * (n + 1) + i] = Polynomial(1);
    return {field, entries};
}

ExactMap::ExactMap(const ExactMap& other) : words_(other.words_.size(), 0) {
    for (std::size_t i = 0; i < words_.size(); ++i) fmpz_set(&words_[i], &other.words_[i]);
}

ExactMap::~ExactMap() {
    for (fmpz& w : words_) fmpz_clear(&w);
}

bool ExactMap::operator==(const ExactMap& other) const {
    return words_.size() == other.words_.size() &&
           std::equal(words_.begin(), words_.end(), other.words_.begin(),
                      [](const fmpz& a, const fmpz& b) { return fmpz_equal(&a, &b) != 0; });
}

std::size_t ExactMap::hash() const {
    constexpr ulong prime = 0xffffffffffffffc5U;         // 2^64 - 59
    constexpr std::size_t spread = 0x9e3779b97f4a7c15U;  // 2^64 over the golden ratio
    std::size_t sum = 0;
    for (const fmpz& w : words_) {
        sum = (sum ^ fmpz_fdiv_ui(&w, prime)) * spread;
        sum ^= sum >> 29U;
    }
    return sum;
}

long ExactMap::bits() const {
    return std::abs(_fmpz_vec_max_bits(words_.data(), static_cast<slong>(words_.size())));
}

ExactMap ExactMap::composed(const FieldFacts& field, const ExactMap& outer, const ExactMap& inner) {
    const auto n = static_cast<std::size_t>(field.dimensions);
    const auto degree = static_cast<std::size_t>(field.degree);
    ExactMap result(outer.words_.size());
    Sum sum(field.degree);
    const auto at = [&](const ExactMap& m, std::size_t row, std::size_t column) {
        return m.words_.data() + (row * (n + 1) + column) * degree;
    };
    for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t column = 0; column <= n; ++column) {
            sum.clear();
            for (std::size_t k = 0; k < n; ++k)
                sum.add(at(outer, row, k), at(inner, k, column), degree);
            fmpz* to = result.words_.data() + (row * (n + 1) + column) * degree;
            sum.take(field, to);
            if (column < n) continue;
            for (std::size_t i = 0; i < degree; ++i)
                fmpz_addmul(to + i, at(outer, row, n) + i, &inner.words_.back());
        }
    }
    fmpz_mul(&result.words_.back(), &outer.words_.back(), &inner.words_.back());
    result.reduce();
    return result;
}

void ExactMap::reduce() {
    fmpz_t common;
    fmpz_init(common);
    for (const fmpz& w : words_) {
        fmpz_gcd(common, common, &w);
        if (fmpz_is_one(common) != 0) break;
    }
    if (fmpz_is_one(common) == 0)
        for (fmpz& w : words_) fmpz_divexact(&w, &w, common);
    fmpz_clear(common);
}

ExactMap::Rounded ExactMap::rounded(const FieldFacts& field) const {
    constexpr double rounding = 0x1p-46;  // of a few operations, the powers included
    const auto degree = static_cast<std::size_t>(field.degree);
    Rounded result;
    const double denominator = fmpz_get_d(&words_.back());
    for (std::size_t e = 0; e < entries_of(field); ++e) {
        double sum = 0, size = 0;
        for (std::size_t i = 0; i < degree; ++i) {
            const double term = fmpz_get_d(&words_[e * degree + i]) * field.generator_power[i];
            sum += term;
            size += std::abs(term);
        }
        result.entry[e] = sum / denominator;
        result.error = std::max(result.error, size / denominator * rounding);
    }
    if (!std::isfinite(result.error)) result.error = INFINITY;
    return result;
}

Polynomial ExactMap::entry(const FieldFacts& field, int row, int column) const {
    const auto n = static_cast<std::size_t>(field.dimensions);
    const auto degree = static_cast<std::size_t>(field.degree);
    const std::size_t from =
        (static_cast<std::size_t>(row) * (n + 1) + static_cast<std::size_t>(column)) * degree;
    Polynomial p;
    for (std::size_t i = 0; i < degree; ++i)
        fmpq_poly_set_coeff_fmpz(p.get(), static_cast<slong>(i), &words_[from + i]);
    fmpq_poly_scalar_div_fmpz(p.get(), p.get(), &words_.back());
    return p;
}

}  // namespace pxm::host::exact
