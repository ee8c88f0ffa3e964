// What the error study sweeps. A setting is a line of a table, an axis a list of lines.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/render/render.hpp"

namespace pxm::host {

struct ErrorSetting {
    std::string name;  // as on the command line
    SceneOverrides overrides;
    bool native_only = false;  // a machine has no such engine
};

/// Every setting of the sweep: one axis at a time away from the default (dsp32, one ray a pixel
/// whatever the scene asks for), then products of those that matter most.
[[nodiscard]] std::vector<ErrorSetting> error_settings();

/// Double, 64 stratified samples, cells ten times finer, room for every cell.
[[nodiscard]] SceneOverrides color_reference();
/// The same with the one ray through the pixel's middle: hits and depths are its.
[[nodiscard]] SceneOverrides depth_reference();

}  // namespace pxm::host
