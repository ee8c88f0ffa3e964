// Scenes by name, `tetra` for a file that somebody else knows the place of: in the folders of
// PXM_SCENE_PATH, then among the scenes that came with pxm (docs/command-line.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pxm::host {
/// Where a scene lies that was looked for.
struct FoundScene {
    std::string path;    // of its file
    std::string folder;  // of the path where it was found, which it may name files of; or empty
};

/// The folders in which scenes are looked for by name, the first first.
[[nodiscard]] std::vector<std::string> scene_folders();

/// The file that a command's SCENE means: that file if there is one, else with `.pxm`, else one of
/// that name, with or without `.pxm`, in the scene folders. Empty if there is none.
[[nodiscard]] std::optional<FoundScene> find_scene(const std::string& name);

/// A file of the scene folders by the path that an `include` wrote. Neither an absolute path nor
/// one that begins by going up names any.
[[nodiscard]] std::optional<FoundScene> find_included(const std::string& written);

/// The names of all scenes in the scene folders, sorted, without `.pxm`.
[[nodiscard]] std::vector<std::string> scene_names();

/// " (did you mean 'tetra'?)" for a scene that is not there; empty if none has a name like it.
[[nodiscard]] std::string suggest_scene(const std::string& missing);

}  // namespace pxm::host
