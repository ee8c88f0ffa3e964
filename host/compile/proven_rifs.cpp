#include "host/compile/proven_rifs.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/compile/build_rifs.hpp"

namespace pxm::host {

namespace {

bool finite(const Affine& map) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (!std::isfinite(map.linear[i][j])) return false;
        }
        if (!std::isfinite(map.translation[i])) return false;
    }
    return true;
}

}  // namespace

std::optional<ProvenRifs> prove_rifs(const IfsBlock& block, Diagnostics& diagnostics) {
    ProvenRifs proven;
    Diagnostics own;
    proven.rifs = build_rifs(block, own);
    const bool broken = own.has_errors();
    diagnostics.append(own);
    if (broken) return std::nullopt;
    for (std::size_t i = 0; i < block.maps.size(); ++i) {
        if (finite(proven.rifs.maps[i])) continue;
        diagnostics.error(block.maps[i].position,
                          fmt::format("map \"{}\" of ifs \"{}\" is not finite",
                                      proven.rifs.map_names[i], block.name));
        return std::nullopt;
    }
    proven.contraction = prove_contraction(proven.rifs);
    if (proven.contraction.proof == ContractionProof::none) {
        diagnostics.error(block.position,
                          fmt::format("ifs \"{}\" could not be shown to contract: {}", block.name,
                                      proven.contraction.obstacle));
        return std::nullopt;
    }
    return proven;
}

}  // namespace pxm::host
