// Affine maps of up to three dimensions with entries of one number field, made for being composed
// and compared very often: whole coefficients over one common denominator, in lowest terms, so that
// equal maps are equal in every word.
#pragma once

#include <flint/fmpz.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "host/fractal/exact/number_field.hpp"

namespace pxm::host::exact {

/// What the maps of one system share.
struct FieldFacts {
    int dimensions = 3;
    int degree = 1;
    std::vector<long> modulus;            // the lowest `degree` coefficients of the monic one
    double generator = 0;                 // up to a relative 1e-15
    std::vector<double> generator_power;  // its powers, from 0
};

class ExactMap {
  public:
    ExactMap() = default;
    /// Of entries in the generator that the field has now, row by row; the last of a row is the
    /// translation's.
    ExactMap(const FieldFacts& field, const std::vector<Polynomial>& entries);
    [[nodiscard]] static ExactMap identity(const FieldFacts& field);

    ExactMap(const ExactMap& other);
    ExactMap(ExactMap&& other) noexcept : words_(std::move(other.words_)) { other.words_.clear(); }
    ExactMap& operator=(ExactMap other) noexcept {
        words_.swap(other.words_);
        return *this;
    }
    ~ExactMap();

    bool operator==(const ExactMap& other) const;
    [[nodiscard]] std::size_t hash() const;
    /// How many bits its longest number has.
    [[nodiscard]] long bits() const;

    /// The map that applies `inner` and then `outer`.
    [[nodiscard]] static ExactMap composed(const FieldFacts& field, const ExactMap& outer,
                                           const ExactMap& inner);

    /// The entries, rounded, and how much each may be wrong at most.
    struct Rounded {
        double entry[12]{};
        double error = 0;
    };
    [[nodiscard]] Rounded rounded(const FieldFacts& field) const;

    /// An entry as an element of the field.
    [[nodiscard]] Polynomial entry(const FieldFacts& field, int row, int column) const;

  private:
    explicit ExactMap(std::size_t words) : words_(words, 0) {}
    void reduce();

    std::vector<fmpz> words_;  // coefficients, then the denominator
};

}  // namespace pxm::host::exact
