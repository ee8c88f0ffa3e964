// The words for what an inspection finds, the same in its JSON and its text.
#pragma once

#include <array>
#include <cstddef>

#include "host/fractal/dimension/open_set.hpp"
#include "host/fractal/system/contraction.hpp"
#include "host/math/lipschitz.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

[[nodiscard]] constexpr const char* kind_name(MapKind kind) {
    constexpr std::array names{"homothety", "similitude", "affine", "singular"};
    return names[static_cast<std::size_t>(kind)];
}

[[nodiscard]] constexpr const char* proof_name(ContractionProof proof) {
    constexpr std::array names{"cycle_mean", "spectral_radius", "words", "none"};
    return names[static_cast<std::size_t>(proof)];
}

[[nodiscard]] constexpr const char* condition_name(OpenSetCondition condition) {
    constexpr std::array names{"holds", "fails", "unknown"};
    return names[static_cast<std::size_t>(condition)];
}

[[nodiscard]] inline const char* kind_name(const DeclaredVolume& volume) {
    constexpr std::array names{"auto", "sphere", "box", "cone", "cylinder", "hull"};
    return names[volume.index()];
}

}  // namespace pxm::host
