// Neighbour maps: how one small piece of an attractor may lie against another of much the same
// size. Pieces w_u and w_v whose words part at the first map are neighbours by w_u^-1 w_v; if there
// are finitely many that do not keep apart, all that pieces can do to each other is known. Some
// neighbour is the identity exactly if two words are the same map; for similitudes the open-set
// condition holds exactly if neighbours do not come near the identity [BG92] [DE05]. All of it is
// measured: whether numbers are equal exactly is asked elsewhere
// (host/fractal/dimension/exact_word).
#pragma once

#include <array>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

enum class Neighbours {
    apart,    // the images of every follow set are disjoint
    finite,   // finitely many that touch or overlap, none the identity
    overlap,  // two words are the same map, up to rounding
    unknown   // there are too many, or maps without inverse, or rounding grew too large, or two
              // words that are not the same map are nearer to it than neighbours are told apart
};

struct NeighbourFinding {
    Neighbours kind = Neighbours::unknown;
    std::size_t count = 0;   // of different neighbours that do not keep apart
    std::vector<int> first;  // the two words that are the same map, or nearly so
    std::vector<int> second;
    double difference = 0;  // of the two, where they place the smaller piece, over its size
    bool complete = false;  // all neighbours are known, and so is which images have common points:
    std::vector<std::array<int, 2>> touching;  // pairs of maps that come in one follow set
};

/// Neighbours that differ by less than 1e-9 of the size, as they place what stands in them, are
/// one. `bounds` as from bound(). Precondition: the system contracts.
[[nodiscard]] NeighbourFinding find_neighbours(const Rifs& rifs, const std::vector<Bounds>& bounds);

}  // namespace pxm::host
