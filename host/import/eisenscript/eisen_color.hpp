// Colours of EisenScript: names, #rgb and #rrggbb, and what steps make of them.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

#include "host/import/eisenscript/eisen_text.hpp"

namespace pxm::host {

/// Nothing if the word is no colour that is known.
[[nodiscard]] std::optional<EisenColor> eisen_color(std::string_view word);

/// The colour after a step of a list.
[[nodiscard]] EisenColor stepped(const EisenColor& color, const EisenTransform& step);

/// Red, green and blue of a scene, which are linear.
[[nodiscard]] glm::dvec3 scene_color(const EisenColor& color);

}  // namespace pxm::host
