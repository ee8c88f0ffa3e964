// A system with its maps in exact numbers, on the smallest affine subspace that they keep and that
// the attractor lies in. What is decided from it is decided for the numbers that the scene writes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "host/fractal/exact/exact_map.hpp"
#include "host/fractal/exact/number_field.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host::exact {

/// x -> A x + a: rows of A, each with its entry of a at the end.
using Entries = std::array<std::array<Algebraic, 4>, 3>;

/// A system's maps as they are written, all in one field.
struct WrittenMaps {
    NumberField field;
    std::vector<Entries> maps;
};

struct ExactSystem {
    NumberField numbers;
    FieldFacts field;                // its `dimensions` are those of the subspace
    std::array<int, 3> axes{};       // coordinates that tell its points apart; `dimensions` of them
    bool along_axes = true;          // the subspace is parallel to them
    std::vector<ExactMap> maps;      // in these coordinates
    std::vector<ExactMap> inverses;  // empty if a map has none
    std::vector<Polynomial> volume_ratio;  // per map: the determinant
    /// Per map: the square of its ratio. Empty unless every map is a similitude of the subspace.
    std::vector<Polynomial> squared_ratio;
    bool equal_ratios = false;  // and these are all the same
    /// The rounded maps' attractor is no further from the exact one than this, times the largest
    /// distance from the origin that it has, or 1.
    double offset = 0;
};

/// Throws NotExact with the reason if exact arithmetic is out of reach. `rifs` has the graph and
/// the maps rounded; maps that do not agree with these are refused.
[[nodiscard]] ExactSystem exact_system(WrittenMaps written, const Rifs& rifs);

/// A vector that the square matrix, given by rows, takes to zero, if there is one up to a factor.
[[nodiscard]] std::optional<std::vector<Polynomial>> kernel_vector(
    const ExactSystem& system, const std::vector<std::vector<Polynomial>>& rows);

/// Of a square matrix of up to three rows.
[[nodiscard]] Polynomial determinant(const ExactSystem& system,
                                     const std::vector<std::vector<Polynomial>>& rows);

/// The largest number that all of them are whole multiples of, rounded; nothing if there is none,
/// or all are 0.
[[nodiscard]] std::optional<double> common_measure(const ExactSystem& system,
                                                   const std::vector<Polynomial>& numbers);

/// Whether the subspace is parallel to the axes that its coordinates are along.
[[nodiscard]] inline bool is_coordinate_plane(const ExactSystem& system) {
    return system.along_axes;
}

}  // namespace pxm::host::exact
