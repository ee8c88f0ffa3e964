// What the channel `neighbours` of a picture needs: how each shape's words are read.
#pragma once

#include "host/compiled/compiled_scene.hpp"
#include "host/engine/neighbour_walk.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// The walk of every shape of a system. `as_written`: no number of the text was replaced from
/// outside. Throws Error, with the system and the reason, where one has no finite graph of
/// neighbours.
[[nodiscard]] NeighbourWalks neighbour_walks(const Scene& scene, bool as_written,
                                             const CompiledScene& compiled);

}  // namespace pxm::host
