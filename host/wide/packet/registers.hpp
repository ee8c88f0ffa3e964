// Which registers the wide engine computes in, on the processor at hand.
#pragma once

#include <string>
#include <vector>

namespace pxm::host {

/// The instruction sets that pxm has code for and the processor has, the one that is used first.
[[nodiscard]] std::vector<std::string> register_sets();

}  // namespace pxm::host
