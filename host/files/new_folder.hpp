// Folders that are on the disk once they are made: the name of one is in the folder above it, and
// only an fsync of that one keeps it when the power fails, with all that lies in the new one.
#pragma once

#include <string>
#include <system_error>

namespace pxm::host {

/// Makes a folder and those above it that are missing. What is there already is no error, unless it
/// is no folder.
[[nodiscard]] std::error_code make_folders(const std::string& path);

/// Brings the names in a folder to the disk. A file system that cannot do this is no reason to give
/// up what is in place.
void sync_folder(const std::string& folder);

}  // namespace pxm::host
