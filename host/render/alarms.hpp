// What a render must not keep silent about: pixels and maps where its numbers may not be enough
// (docs/alarms.md). Looked for by the host when the frame is there; nodes know nothing of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/engine/frame.hpp"

namespace pxm::host {

/// Marks the frame's pixels and returns every alarm, also those that count 0.
[[nodiscard]] std::vector<Alarm> raise_alarms(const CompiledScene& scene, Numeric numeric,
                                              Frame& frame);

/// Adds the pixels of another part of the same picture; maps are the same in all parts.
void add_pixels(std::vector<Alarm>& sum, const std::vector<Alarm>& part);

/// The lines for stderr: one for each alarm that counts anything.
[[nodiscard]] std::string alarm_text(const std::vector<Alarm>& alarms);

}  // namespace pxm::host
