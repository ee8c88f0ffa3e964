// What is known of a scene without rendering it.
#pragma once

#include <string>

#include "host/scene/check/settings.hpp"

namespace pxm::host {

struct Findings {
    bool errors = false;
    bool warnings = false;
    std::string text;  // all of them, as a render would tell them; lines without the last newline
};

/// Every frame of an animation is looked at, up to the first mistake; warnings that come with a
/// later frame are told with the first of these alone. Parses, checks and compiles the scene, and
/// finds its method of intersection. What is wrong with it or with a file that it names is in the
/// findings. Throws Error: the scene's own file cannot be read (4), a setting is wrong (2).
[[nodiscard]] Findings findings_of(const std::string& scene_path, const Settings& settings,
                                   const std::vector<std::string>& allowed = {});

}  // namespace pxm::host
