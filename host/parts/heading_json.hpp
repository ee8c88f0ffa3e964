// A part's heading as one line of JSON.
#pragma once

#include <string>

#include "host/parts/part_heading.hpp"

namespace pxm::host {

[[nodiscard]] std::string heading_json(const PartHeading& heading);

/// What heading_json() wrote. Throws std::exception if the text is anything else.
[[nodiscard]] PartHeading heading_of_json(const std::string& text);

}  // namespace pxm::host
