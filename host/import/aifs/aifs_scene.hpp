// A block of IFStile's language as a scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/import/import.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Blocks are chosen by name or `#3`, and a set of one by `NAME:SET`. Throws Error as import_file
/// does.
[[nodiscard]] Imported import_aifs(const SourceFile& source,
                                   const std::optional<std::string>& entry);

/// The names of all blocks that can be asked for. Throws Error(scene): it is no AIFS.
[[nodiscard]] std::vector<std::string> aifs_names(const SourceFile& source);

}  // namespace pxm::host
