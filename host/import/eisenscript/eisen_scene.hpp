// An EisenScript as a scene.
#pragma once

#include <cstdint>

#include "host/import/import.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// `seed` chooses among rules of one name. Throws Error as import_file does.
[[nodiscard]] Imported import_eisenscript(const SourceFile& source, std::uint64_t seed);

}  // namespace pxm::host
