// The stiff and extreme scenes of the stability study, as texts. One table: a case is a line.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/check/settings.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

struct StabilityCase {
    std::string name;
    std::string family;
    double value = 0;  // the family's parameter
    /// Volumes are part of the picture: those that the scene would be given may change with its
    /// scale.
    std::optional<VolumeKind> volume = VolumeKind::sphere;
    /// Hopeless scenes get few pixels and an early end: absent are 64x48 pixels and the usual cap.
    std::optional<PixelSize> size;
    std::optional<std::uint32_t> cell_cap;
    /// A scene of the user's, as it is; empty: `text` makes one.
    std::string path = {};
    /// The scene with all lengths of the world multiplied by `unit`: the same picture in exact
    /// numbers, other roundings.
    std::function<std::string(double unit)> text;
    Settings settings = {};                 // of a user's scene
    std::vector<std::string> allowed = {};  // of a user's scene: folders beside its own
};

[[nodiscard]] std::vector<StabilityCase> stability_cases();

/// A user's scene with one ray a pixel.
[[nodiscard]] StabilityCase case_of(const std::string& scene,
                                    const std::vector<std::string>& allowed,
                                    const std::optional<PixelSize>& size);

}  // namespace pxm::host
