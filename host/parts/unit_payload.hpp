// A unit as bytes: its counts, then for each kept value of a pixel the values of all its pixels,
// words of 32 bits in which equal neighbours stand once. Nothing is rounded.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/engine/aov.hpp"
#include "host/engine/units.hpp"
#include "host/render/alarms.hpp"

namespace pxm::host {

/// What is read back. Values of pixels that were not kept are those of a miss.
struct StoredUnit {
    RayStatistics rays;
    AlarmSums alarms;
    std::optional<NodeStatistics> node;  // its id, column and row are not stored
    std::vector<PixelRecord> pixels;
};

[[nodiscard]] std::string payload_of(const FinishedUnit& unit, const AlarmSums& alarms,
                                     const std::vector<Aov>& channels);

/// The unit of so many pixels; empty if the bytes are none. `memory` becomes its pixels: any that
/// are as new but for these channels, such as those of another unit.
[[nodiscard]] std::optional<StoredUnit> unit_of_payload(std::string_view bytes, std::size_t pixels,
                                                        const std::vector<Aov>& channels,
                                                        std::vector<PixelRecord> memory = {});

}  // namespace pxm::host
