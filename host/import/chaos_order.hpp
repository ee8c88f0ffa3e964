// Chaos games that say which map may come *after* which (xaos), in the order of a scene. What was
// done last is the outermost map: inside a map may stand those that it may come after.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace pxm::host {

/// True if map `next` may come after map `before`.
using MayComeAfter = std::function<bool(std::size_t before, std::size_t next)>;

/// Those of `maps` that may come however long the game has gone on: each may come after another one
/// of them. The others are a matter of the first points, which are not shown.
[[nodiscard]] std::vector<std::size_t> lasting_maps(const std::vector<std::size_t>& maps,
                                                    const MayComeAfter& after);

}  // namespace pxm::host
