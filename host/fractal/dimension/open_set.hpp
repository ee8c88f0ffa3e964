// The open-set condition (Def. 3.9), where it can be decided: an open set for each follow set whose
// images lie inside and apart from each other, or a reason why there is none. Of a graph, only what
// recurs is asked: the follow sets that a cycle passes with the maps that stay in their component.
// Other maps add finitely many copies of it, or copies that no dimension depends on.
#pragma once

#include <string>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

enum class OpenSetCondition { holds, fails, unknown };  // whether it is satisfied

struct OpenSetFinding {                                      // the answer
    OpenSetCondition condition = OpenSetCondition::unknown;  // what was decided
    std::string why;  // the open set, or the obstacle; up to rounding
};

/// Whether the numbers of maps are a scene's own, or were computed from these.
enum class MapNumbers { given, computed };

/// That words are the same map is called exact for given numbers alone. `bounds` as from bound();
/// they may be those of the system that was given. Precondition: the system contracts, and every
/// follow set is reached from the start.
[[nodiscard]] OpenSetFinding decide_open_set(const Rifs& rifs, const std::vector<Bounds>& bounds,
                                             MapNumbers numbers = MapNumbers::given);

}  // namespace pxm::host
