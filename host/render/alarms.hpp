// What a render must not keep silent about: pixels and maps where its numbers may not be enough
// (docs/alarms.md). Looked for by the host when the frame is there; nodes know nothing of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/render/compiled_scene.hpp"
#include "host/render/frame.hpp"

namespace pxm::host {

/// Bits of PixelRecord::alarms.
enum PixelAlarm : std::uint8_t {
    alarm_precision = 1,   // the pixel is few units of the last place wide where it looks
    alarm_floored = 2,     // p would have to be finer than the numbers allow
    alarm_capped = 4,      // a ray of it was given up
    alarm_not_finite = 8,  // its depth, colour or normal is no number
    alarm_overflow = 16,   // a result on the way to it was beyond the numbers' range
};

struct Alarm {
    std::string name;         // in --stats
    std::uint64_t count = 0;  // pixels, or maps
    std::string text;         // for the user
    bool of_pixels = true;    // not of maps
};

/// Marks the frame's pixels and returns every alarm, also those that count 0.
[[nodiscard]] std::vector<Alarm> raise_alarms(const CompiledScene& scene, Numeric numeric,
                                              Frame& frame);

/// Adds the pixels of another part of the same picture; maps are the same in all parts.
void add_pixels(std::vector<Alarm>& sum, const std::vector<Alarm>& part);

/// The lines for stderr: one for each alarm that counts anything.
[[nodiscard]] std::string alarm_text(const std::vector<Alarm>& alarms);

}  // namespace pxm::host
