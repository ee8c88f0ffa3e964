// The open-set condition (Def. 3.9), where it can be decided: a convex open set for each follow set
// whose images lie inside and apart from each other, or a reason why there is none.
#pragma once

#include <string>
#include <vector>

#include "host/fractal/rifs.hpp"

namespace pxm::host {

enum class OpenSetCondition { holds, fails, unknown };

struct OpenSetFinding {
    OpenSetCondition condition = OpenSetCondition::unknown;
    std::string why;  // the open set, or the obstacle; up to rounding
};

/// Precondition: the system contracts, and every follow set is reached from the start.
[[nodiscard]] OpenSetFinding decide_open_set(const Rifs& rifs);

}  // namespace pxm::host
