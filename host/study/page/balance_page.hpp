// The balance study as tables and as a page.
#pragma once

#include <string>
#include <vector>

#include "host/study/study.hpp"

namespace pxm::host {

/// CSV files of data.json: scenes, nodes and curves.
[[nodiscard]] std::vector<TextFile> balance_tables(const Json& data);
/// The report; the pictures named in `data` are read from `folder`.
[[nodiscard]] std::string balance_page(const Json& data, const std::string& folder);

}  // namespace pxm::host
