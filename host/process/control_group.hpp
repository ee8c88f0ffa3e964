// The control groups that the process is in, as folders of their hierarchy. A limit of any group
// around the process's own holds for it too.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pxm::host {

enum class GroupVersion { one, two };

/// The folders of the process's group and of those around it, the outermost first, as far as they
/// are mounted; of version 1 in the hierarchy of `controller`. `root` is the folder of `proc` and
/// `sys`.
[[nodiscard]] std::vector<std::filesystem::path> group_folders(const std::filesystem::path& root,
                                                               GroupVersion version,
                                                               const char* controller);

/// The first line's words of a file; none if it cannot be read.
[[nodiscard]] std::vector<std::string> first_words(const std::filesystem::path& path);

}  // namespace pxm::host
