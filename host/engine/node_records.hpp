// Which records of a frame are a node's, and what a fault of a node becomes for the user.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "host/engine/frame.hpp"
#include "host/engine/units.hpp"
#include "host/error.hpp"
#include "pxm/fault.hpp"
#include "pxm/model.hpp"

namespace pxm::host {

/// Throws Error(ErrorKind::machine_limit) if there is a fault.
inline void refuse(const std::optional<Fault>& fault, const Model& model) {
    if (!fault) return;
    throw Error(
        ErrorKind::machine_limit,
        fmt::format("the {} of node {} of the {} is too small: {} bytes wanted, {} there",
                    fault->bank, fault->node, model.name, fault->wanted_bytes, fault->limit_bytes));
}

/// Those records of a frame that are a node's.
[[nodiscard]] inline std::vector<PixelRecord> records_of(const Frame& frame,
                                                         const UnitPixels& unit) {
    std::vector<PixelRecord> records;
    records.reserve(unit.count());
    for (long y = unit.y0; y < unit.y1; y += unit.step_y)
        for (long x = unit.x0; x < unit.x1; x += unit.step_x) records.push_back(frame.at(x, y));
    return records;
}

}  // namespace pxm::host
