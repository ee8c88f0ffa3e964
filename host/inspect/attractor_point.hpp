// A point of an attractor to many digits, for a camera to look at in deep zooms.
#pragma once

#include <string>
#include <vector>

#include "host/scene/scene.hpp"

namespace pxm::host {

/// Where in the world the first object with an ifs has the point whose address repeats `word` for
/// ever: maps by name or number, outermost first. As a camera's `look` wants it: "x,y,z", 60
/// decimals. Precondition: the scene was found right. Throws Error(command_line) if there is no
/// such object or address.
[[nodiscard]] std::string attractor_point(const Scene& scene, const std::vector<std::string>& word);

}  // namespace pxm::host
