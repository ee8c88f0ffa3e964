// A group of translations in exact numbers: whether it is a lattice, how large a cell of it is, and
// what belongs to it.
#pragma once

#include <flint/fmpz_mat.h>

#include <memory>
#include <optional>
#include <vector>

#include "host/fractal/exact/exact_system.hpp"

namespace pxm::host::exact {

class Lattice {
  public:
    using Vector = std::vector<Polynomial>;

    /// What the vectors generate; nothing if that is no lattice of the system's whole space: they
    /// lie in less of it, or some sum of them is as short as one likes.
    [[nodiscard]] static std::optional<Lattice> generated(const ExactSystem& system,
                                                          const std::vector<Vector>& vectors);

    [[nodiscard]] bool contains(const Vector& vector) const;
    /// The volume of a cell, rounded.
    [[nodiscard]] double cell() const;

  private:
    struct Inside;
    explicit Lattice(std::shared_ptr<Inside> inside) : inside_(std::move(inside)) {}

    std::shared_ptr<Inside> inside_;
};

}  // namespace pxm::host::exact
