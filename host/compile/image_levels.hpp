// A texture's picture in all the sizes that the nodes keep: each half as large as the one before,
// down to a single texel, which is the picture's mean.
#pragma once

#include <cstdint>
#include <vector>

#include "host/compiled/compiled_floor.hpp"
#include "host/files/image_reader.hpp"

namespace pxm::host {

/// The picture, then half of it and so on; sides are halved downwards to no less than 1. Every
/// level has the mean of the picture.
[[nodiscard]] std::vector<LinearPicture> make_levels(LinearPicture picture);

/// Adds the texels of all levels to texture memory and says where they are in `texture`: the unit
/// is such that the brightest texel fits. Fills in levels, unit and mean.
void store_levels(const std::vector<LinearPicture>& levels, CompiledTexture& texture,
                  std::vector<std::uint32_t>& texture_words);

}  // namespace pxm::host
