// The lines of `pxm inspect` for what exact numbers decide, and for the measure.
#pragma once

#include <string>

#include "host/inspect/inspection.hpp"

namespace pxm::host {

[[nodiscard]] std::string exact_text(const IfsFacts& ifs);

}  // namespace pxm::host
