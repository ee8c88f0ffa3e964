// IFSRenderer's .ifsjson files (docs/import.md): iterators of three dimensions, each a transform by
// name with its numbers, mixed with the point that it is given, and which may come after which.
// The one place of imports that knows JSON.
#pragma once

#include "host/import/import.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Throws Error(scene): not such a file, or an iterator that is not affine, by its name.
[[nodiscard]] Imported import_ifsjson(const SourceFile& source);

}  // namespace pxm::host
