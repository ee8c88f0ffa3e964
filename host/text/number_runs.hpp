// Whole numbers in a sentence: "3, 5-7, 12".
#pragma once

#include <set>
#include <string>

namespace pxm::host {

/// The numbers with their runs as "5-7"; what is beyond 20 runs is "...".
[[nodiscard]] std::string number_runs(const std::set<long>& numbers);

}  // namespace pxm::host
