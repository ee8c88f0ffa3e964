// From imported maps to a whole scene that `render` takes, and its text.
#pragma once

#include <string>
#include <string_view>

#include "host/scene/scene.hpp"

namespace pxm::host {

enum class Space { plane, solid };  // maps of the plane z = 0, or of space

/// A name of the scene language for any text: other characters become '_'.
[[nodiscard]] std::string scene_name(std::string_view text);

/// The scene of one IFS. Maps of the plane are seen from the front, y up, in an orthographic view
/// that just holds them. Throws Error(ErrorKind::scene), with the reason at the block's place in
/// `source`, if the maps could not be shown to contract.
[[nodiscard]] Scene imported_scene(IfsBlock maps, const std::string& name, Space space,
                                   const SourceFile& source);

/// The scene's text under a heading of comment lines.
[[nodiscard]] std::string imported_text(const Scene& scene, const std::string& heading);

}  // namespace pxm::host
