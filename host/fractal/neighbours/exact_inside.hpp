// Whether an attractor has an inside within the line, plane or space that it lies in, and its
// length, area or volume.
#pragma once

#include <optional>

#include "host/fractal/neighbours/decided.hpp"
#include "host/fractal/neighbours/exact_findings.hpp"
#include "host/fractal/neighbours/searched_system.hpp"
#include "host/fractal/neighbours/volume_range.hpp"

namespace pxm::host {

struct ExactInside {
    Decided<bool> inside;
    Decided<double> volume;
    std::optional<VolumeBracket> between;  // if that is not decided at once
};

/// `found` has what was decided before: overlaps, the open-set condition, connectedness, dimension.
[[nodiscard]] ExactInside exact_inside(const SearchedSystem& searched, const ExactFindings& found);

/// Whether it is a connected set in a line.
[[nodiscard]] inline bool is_interval(const SearchedSystem& searched, const ExactFindings& found) {
    return searched.full && found.dimensions == 1 && found.connected.value.value_or(false);
}

}  // namespace pxm::host
