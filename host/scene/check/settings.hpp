// `--set KEY=VALUE`: numbers named by `let` and values of blocks from outside of the scene's text,
// in the scene's own words (docs/scene-language.md, "Set from outside").
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// One setting as it was written.
struct Setting {
    std::string key;    // `height`, `camera.fov`, `object.elm.levels`, `ifs.elm.leaf.color`
    std::string value;  // an expression, or what stands behind the directive's colon
    bool operator==(const Setting&) const = default;
};
using Settings = std::vector<Setting>;  // in the order written

/// Of `KEY=VALUE`. Throws Error(ErrorKind::setting).
[[nodiscard]] Setting parse_setting(const std::string& text);
[[nodiscard]] Settings parse_settings(const std::vector<std::string>& texts);  // of each text

/// "--set camera.fov=30", quoted where it has blanks; of several with blanks between them.
[[nodiscard]] std::string text_of(const Setting& setting);
[[nodiscard]] std::string text_of(const Settings& settings);  // of all of them

/// Parses the scene file at `path` (parser.hpp) as if it said what is set; the last setting of a
/// key wins. The scene's own mistakes go to `diagnostics`; a setting that names nothing, cannot be
/// read or makes a sound scene wrong (check.hpp) is an Error(ErrorKind::setting).
[[nodiscard]] Scene parse_scene(const std::string& path, const Settings& settings,
                                Diagnostics& diagnostics,
                                const std::vector<std::string>& allowed = {},
                                const std::optional<std::string>& text = {}, double frame = 0);

}  // namespace pxm::host
