// The options of `pxm render` that say over the scene how it is rendered: one list of them, from
// which they are declared, read and noted in the picture.
#pragma once

#include <string>

#include "host/commands/cmd.hpp"
#include "host/commands/render_arguments.hpp"
#include "host/render/render_options.hpp"

namespace pxm::host {

void add_scene_options(CommandOptions& command, RenderArguments& arguments);

/// Throws Error (setting) where the text of one is not what it may be.
[[nodiscard]] SceneOverrides overrides_of(const RenderArguments& arguments);

/// Those that were given, as a picture notes them; it notes what its numbers are by itself.
[[nodiscard]] std::string noted_options(const RenderArguments& arguments);

}  // namespace pxm::host
