// An ifs block as a system that was shown to contract: what every use of a fractal starts from.
#pragma once

#include <optional>

#include "host/fractal/system/contraction.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

struct ProvenRifs {
    Rifs rifs;
    Contraction contraction;
};

/// Builds the graph, checks that the maps are finite and that the system contracts. Nothing if an
/// error was added to `diagnostics`.
[[nodiscard]] std::optional<ProvenRifs> prove_rifs(const IfsBlock& block, Diagnostics& diagnostics);

}  // namespace pxm::host
