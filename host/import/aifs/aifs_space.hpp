// From the space of IFStile's maps to the plane or the space that is shown: an invariant subspace
// of a matrix, with the other ones left out.
#pragma once

#include <vector>

#include "host/import/aifs/aifs_evaluator.hpp"

namespace pxm::host {

/// Takes points of n dimensions to what is shown of them, 1 to 3.
class AifsProjection {
  public:
    /// The whole space if the system names no subspace. Throws AifsMistake at `place`: more than
    /// three dimensions, no such part, or an eigenvalue that is not simple.
    AifsProjection(const AifsSystem& system, const Position& place);

    [[nodiscard]] std::size_t dimension() const { return shown_; }
    /// What the map does to what is shown. Throws AifsMistake if that depends on what is not.
    [[nodiscard]] AffineN operator()(const AffineN& map) const;

  private:
    std::size_t full_;
    std::size_t shown_;
    std::vector<double> rows_;     // shown_ x full_
    std::vector<double> inverse_;  // full_ x shown_: rows_ times it is the identity
    Position place_;
};

}  // namespace pxm::host
