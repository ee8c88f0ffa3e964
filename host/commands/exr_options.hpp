// What `pxm render` is told of an EXR alone: --half, --data-window, --cryptomatte.
#pragma once

#include <string>
#include <vector>

#include "host/commands/render_arguments.hpp"
#include "host/engine/aov.hpp"
#include "host/output/image.hpp"
#include "host/render/mattes.hpp"
#include "host/render/render.hpp"

namespace pxm::host {

/// Throws Error(ErrorKind::setting) unless the options can be had together, for pictures at `out`;
/// empty where the picture is made of parts.
void require_exr_options(const RenderArguments& arguments, const std::vector<Aov>& aovs,
                         const std::string& out);

/// How the picture is to be written, for its metadata.
[[nodiscard]] Metadata exr_metadata(const RenderArguments& arguments, const PixelSize& image);

/// The value of --cryptomatte. Throws Error(ErrorKind::setting).
[[nodiscard]] std::vector<MatteKind> parse_mattes(const std::string& text);

/// The channels of mattes, which must outlive them.
[[nodiscard]] ExtraChannels matte_channels(const std::vector<MatteLayer>& layers);

}  // namespace pxm::host
