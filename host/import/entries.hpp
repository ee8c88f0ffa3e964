// Files that hold several systems: which of them is meant, and how one becomes a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/import/import.hpp"

namespace pxm::host {

/// The number of the entry asked for: by its exact name if there is one, else whatever its case,
/// else by its place, `#3`. Throws Error: none is there (3), or none of that name, or several and
/// none asked for (2).
[[nodiscard]] std::size_t choose_entry(const std::vector<std::string>& names,
                                       const std::string& file,
                                       const std::optional<std::string>& wanted);

/// The last part of a path, fit to be shown; and without its extension, as it is.
[[nodiscard]] std::string file_name(const std::string& path);
[[nodiscard]] std::string bare_name(const std::string& path);

/// The scene under a heading. What is written can be read again and compiled: numbers that only
/// overflow on the way there are found here, and not by whoever renders the scene.
[[nodiscard]] Imported finished(Scene scene, const std::string& heading);

}  // namespace pxm::host
