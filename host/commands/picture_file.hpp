// The file of one picture of `pxm render`: its channels, what it says of itself, and its bytes,
// which are written while rays are followed.
#pragma once

#include <string>
#include <vector>

#include "host/commands/picture_options.hpp"
#include "host/commands/render_arguments.hpp"
#include "host/engine/aov.hpp"
#include "host/files/picture_library.hpp"
#include "host/render/render.hpp"

namespace pxm::host {

/// The channels that were asked for. Throws Error (setting) for those that the engine has not.
[[nodiscard]] std::vector<Aov> aovs_of(const RenderArguments& arguments);

[[nodiscard]] Metadata metadata_of(const RenderArguments& arguments, const RenderResult& result,
                                   SceneCarrier& carrier, double frame);

/// Whether what is known to be doubtful is told before the first ray, or by whoever collects it.
enum class Warnings { before, after };

/// Renders one picture into its file. Nothing is written of one that was stopped, unless a limit
/// did so and there is a `partial`, which then says what is missing.
RenderResult write_picture(const RenderArguments& arguments, const RenderRequest& request,
                           const std::string& out, const RunControl& control, Warnings warnings,
                           SceneCarrier& carrier, std::string* partial = nullptr);

}  // namespace pxm::host
