// --stats FILE.json: the statistics of a render as JSON, with the keys of docs/command-line.md.
#pragma once

#include <string>

#include "host/engine/statistics.hpp"

namespace pxm::host {

/// The whole text, with an end of line.
[[nodiscard]] std::string statistics_json(const Statistics& statistics);

}  // namespace pxm::host
