// How a cell's word is read for the channel `neighbours` (docs/command-line.md): state by state,
// map by map. The number of the last state is that of the cell's neighbourhood.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "host/engine/engine.hpp"

namespace pxm::host {

struct NeighbourWalk {
    /// Per state and map of the shape: the state after it; -1 where it may not follow.
    std::vector<std::vector<std::int32_t>> next;
};

/// Per shape of a scene; none for a volume that is an object itself.
using NeighbourWalks = std::vector<std::shared_ptr<const NeighbourWalk>>;

/// The reference engine, whose pixels have the number of a cell's neighbourhood, from 1 on, where
/// those of the machine have cycles. No walks: as load_reference().
[[nodiscard]] std::unique_ptr<LoadedScene> load_reference_with(const CompiledScene& scene,
                                                               const EngineChoice& choice,
                                                               NeighbourWalks walks);

}  // namespace pxm::host
