// A block of IFStile's language as a scene.
#pragma once

#include <optional>
#include <string>

#include "host/import/import.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Blocks are chosen by name or `#3`, and a set of one by `NAME:SET`. Throws Error as import_file
/// does.
[[nodiscard]] Imported import_aifs(const SourceFile& source,
                                   const std::optional<std::string>& entry);

}  // namespace pxm::host
