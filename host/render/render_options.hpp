// Texts of option values: `--size 640x480`, `--crop 0,0,8,8`, `--covers on`, ... Each function
// throws Error(ErrorKind::setting) that names the option, what was found and what was expected.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "host/output/image.hpp"
#include "host/render/render.hpp"
#include "host/scene/scene.hpp"
#include "pxm/model.hpp"

namespace pxm::host {

[[nodiscard]] PixelSize parse_size(const std::string& text);
[[nodiscard]] CropWindow parse_crop(const std::string& text);
[[nodiscard]] std::pair<long, long> parse_pixel(const std::string& text);
[[nodiscard]] CoversChoice parse_covers(const std::string& text);
[[nodiscard]] std::vector<Aov> parse_aovs(const std::string& text);
[[nodiscard]] Numeric parse_numeric(const std::string& text);
[[nodiscard]] Shading parse_shading(const std::string& text);
[[nodiscard]] IntersectMethod parse_intersect(const std::string& text);
[[nodiscard]] LipschitzMethod parse_lipschitz(const std::string& text);
[[nodiscard]] VolumeKind parse_volume(const std::string& text);
[[nodiscard]] const Model& parse_model(const char* option, const std::string& text);

}  // namespace pxm::host
