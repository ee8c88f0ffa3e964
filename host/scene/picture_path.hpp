// Where the picture of a texture is looked for.
#pragma once

#include <string>

#include "host/scene/scene.hpp"

namespace pxm::host {

/// A path is relative to the file that says it, as an include's is.
[[nodiscard]] std::string picture_path(const Scene& scene, const TextureBlock& texture,
                                       const FileTexture& source);

}  // namespace pxm::host
