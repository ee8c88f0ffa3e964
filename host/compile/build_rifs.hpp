// From an ifs block to a system ready for mathematics: the one place where names of maps become
// numbers.
#pragma once

#include "host/fractal/system/rifs.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Builds the system of an ifs block: resolves names, shares follow sets, and finds the start maps
/// (strongly connected components of in-degree zero, Sec. 7.2.2, unless the block says `start:`).
/// Unknown names, maps that nothing may follow and an ifs without maps are errors; maps that no
/// start map leads to are warnings. The result is usable only if no error was added.
[[nodiscard]] Rifs build_rifs(const IfsBlock& block, Diagnostics& diagnostics);

}  // namespace pxm::host
