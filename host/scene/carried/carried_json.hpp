// What a picture carries as text: JSON in plain ASCII, so that no byte of a scene ends anything.
#pragma once

#include <string>

#include "host/scene/carried/carried_scene.hpp"

namespace pxm::host {

/// At most carried_bytes: a scene that is larger is left out, here and in the text.
[[nodiscard]] std::string carried_json(CarriedScene& carried);

/// Whether a file may have this name in it: one that starts at the scene's folder and can be shown.
[[nodiscard]] bool is_carried_name(const std::string& name);

/// The reverse. Throws std::exception if it is none, or names files as no scene of pxm does.
[[nodiscard]] CarriedScene carried_of_json(const std::string& text);

}  // namespace pxm::host
