// What follows from the graph of neighbours (docs/neighbours.md has the theorems): overlaps, the
// open-set condition, connectedness, the Hausdorff dimension, inside, boundary. Each is decided in
// the scene's very numbers, or left open with the reason.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/neighbours/decided.hpp"
#include "host/fractal/neighbours/neighbour_limits.hpp"
#include "host/fractal/neighbours/volume_range.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

namespace exact {
struct WrittenMaps;
}

/// A type of neighbours: E_first against map(E_second).
struct TouchingType {
    int first = 0;                // follow sets
    int second = 0;               // the follow set of the other cell
    bool identity = false;        // the two cells are the same
    std::vector<double> entries;  // rounded, by rows, each with its translation at the end
    /// Maps within the first and the second cell, -1 for none, and the type that they lead to.
    std::vector<std::array<int, 3>> edges;
};

struct ExactFindings {        // what is decided of a system
    std::string numbers;      // what the maps' numbers are, or why they are not had exactly
    int degree = 0;           // of the number field; 0: exact numbers are not had
    int interval_digits = 0;  // of balls that the numbers are known in; 0: not decided by these
    int dimensions = 3;       // of the affine subspace that the attractor lies in

    Decided<bool> finite;              // are there finitely many types of neighbours?
    std::size_t types = 0;             // that touch, the identity included if cells coincide
    std::size_t touching = 0;          // those that are not the identity
    std::array<int, 3> axes{0, 1, 2};  // coordinates that the types' maps are in
    std::vector<TouchingType> graph;   // if it is finite
    /// Per follow set: two of its maps, and the type of their images.
    std::vector<std::vector<std::array<int, 3>>> own;
    std::vector<std::array<int, 2>> touching_maps;  // of the start: images with a common point
    Decided<std::size_t> triples;      // pairs of neighbours that meet at a point of their cell
    Decided<double> triple_dimension;  // of the points where three cells meet

    Decided<bool> overlaps;                             // are two words the same map?
    std::array<std::vector<int>, 2> overlapping_words;  // two words that are the same map, or empty
    /// The system without words that equal an earlier one, if it was needed: per state its maps and
    /// the states that they lead to; the first is that of the whole.
    std::vector<std::vector<std::array<int, 2>>> distinct;
    Decided<bool> open_set;                    // is the open-set condition satisfied?
    Decided<bool> connected;                   // is the attractor one piece?
    std::vector<std::size_t> parts_of_levels;  // 1, 2 ..., if it is not connected
    Decided<std::size_t> components;           // how many connected pieces it has
    std::optional<bool> infinite_components;   // whether there is no such number
    Decided<bool> totally_disconnected;        // is every piece of it a point?
    Decided<double> hausdorff;                 // its Hausdorff dimension
    Decided<double> shadow;    // the largest Hausdorff dimension of a projection along axes
    Decided<double> boundary;  // its dimension
    Decided<bool> interior;    // within the subspace
    Decided<double> volume;    // and its length, area or volume
    std::optional<VolumeBracket> volume_between;  // certified, if that is not decided at once
};

/// `written` are the maps of `rifs` as the scene's text has them; `bounds` as from bound().
/// Precondition: the system contracts, and every follow set is reached from the start.
[[nodiscard]] ExactFindings find_exactly(exact::WrittenMaps written, const Rifs& rifs,
                                         const std::vector<Bounds>& bounds,
                                         const NeighbourLimits& limits);

/// Nothing decided, for that reason.
[[nodiscard]] inline ExactFindings nothing_exact(const std::string& why) {
    ExactFindings found;
    found.numbers = why;
    const std::string because = "no exact numbers: " + why;
    found.finite.why = found.overlaps.why = found.open_set.why = found.connected.why = because;
    found.components.why = because;
    found.totally_disconnected.why = found.hausdorff.why = found.boundary.why = because;
    found.interior.why = found.volume.why = because;
    found.triples.why = found.triple_dimension.why = because;
    return found;
}

}  // namespace pxm::host
