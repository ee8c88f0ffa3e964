// Where the files lie that come with the program: the modules with libraries for pictures, and the
// scenes. They are found from the program's own place, so that an installed tree may be moved as a
// whole.
#pragma once

#include <filesystem>
#include <vector>

namespace pxm::host {

/// The folders that may hold modules, the first first: the one that was set, the one that stands to
/// the program as it was installed, the one where it was built, and the one where it was to be
/// installed.
[[nodiscard]] std::vector<std::filesystem::path> module_folders();

/// The same of what is read: a folder `scenes` lies in each.
[[nodiscard]] std::vector<std::filesystem::path> data_folders();

/// For programs that use pxm as a library and lie elsewhere than it (docs/library.md): modules are
/// looked for here first. To be called before the first picture is read or written.
void look_for_modules_in(const std::filesystem::path& folder);

/// The same of the folder in which `scenes` lies. To be called before the first scene is looked
/// for.
void look_for_data_in(const std::filesystem::path& folder);

}  // namespace pxm::host
