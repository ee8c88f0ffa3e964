// The shading study as a table and as a page.
#pragma once

#include <string>
#include <vector>

#include "host/study/study.hpp"

namespace pxm::host {

[[nodiscard]] std::vector<TextFile> shading_tables(const Json& data);
[[nodiscard]] std::string shading_page(const Json& data, const std::string& folder);

}  // namespace pxm::host
