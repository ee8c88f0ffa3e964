// Where the files that a scene names may lie: below the folder of the scene, and below those that
// the user allows. A scene from elsewhere is read on trust in pxm, not in its author: it may not
// look at the rest of the disk.
#pragma once

#include <string>
#include <vector>

namespace pxm::host {

class AllowedFolders {
  public:
    /// Everywhere: for text that is in memory and has no folder.
    AllowedFolders() = default;
    /// The folder that holds `scene_path`, and `allowed`. Throws Error(ErrorKind::setting) if
    /// one of `allowed` is not a folder.
    AllowedFolders(const std::string& scene_path, const std::vector<std::string>& allowed);

    /// Files below this folder, too, if it is one. Everywhere stays everywhere.
    void allow(const std::string& folder);

    /// The file's path with its links followed. Throws Error(ErrorKind::file) if that is outside;
    /// the message says how to allow it, and not whether there is such a file.
    [[nodiscard]] std::string resolved(const std::string& path) const;

  private:
    std::vector<std::string> folders_;  // links followed, '/' at the end; empty: everywhere
};

}  // namespace pxm::host
