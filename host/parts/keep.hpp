// A render that survives: units that are done are put into a folder now and then, and a run that
// finds them there renders the others.
#pragma once

#include <string>

#include "host/parts/part_run.hpp"

namespace pxm::host {

/// What a folder holds of a picture. A file that is damaged counts as absent, and is named in
/// `warnings`. Throws Error(ErrorKind::file) if there are parts of another picture.
[[nodiscard]] PartSet kept_parts(const std::string& folder, const PartHeading& heading,
                                 std::string& warnings);

/// Renders the units that are missing, puts them into the folder, and takes them in. False if it
/// was stopped: then what was done is there.
[[nodiscard]] bool render_missing(const UnitRender& render, const std::string& folder,
                                  PartSet& parts);

}  // namespace pxm::host
