// The error study as a table and as a page.
#pragma once

#include <string>
#include <vector>

#include "host/study/study.hpp"

namespace pxm::host {

[[nodiscard]] std::vector<TextFile> error_tables(const Json& data);
[[nodiscard]] std::string error_page(const Json& data, const std::string& folder);

}  // namespace pxm::host
