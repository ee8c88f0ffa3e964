// What a render must not keep silent about: pixels and maps where its numbers may not be enough
// (docs/alarms.md). Looked for by the host when the frame is there; nodes know nothing of it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/engine/frame.hpp"
#include "host/engine/statistics.hpp"

namespace pxm::host {

/// An object's outermost volume, or that of a cell which is an object, seen from the eye, in scene
/// units.
struct AlarmPlace {
    int origin = 0;       // number of the object in the scene
    double distance = 0;  // of its middle
    double diameter = 0;
    double begin = 0;  // what is nearer than that, or farther than the end, is not of the object
    double end = 0;
    bool operator==(const AlarmPlace&) const = default;
};

/// All that the alarms of a picture depend on beside its pixels.
struct AlarmBasis {
    Numeric numeric = Numeric::single;
    double pixel_at_eye = 0;  // p(t) = pixel_at_eye + pixel_growth t, scene units (Eq. 15.2)
    double pixel_growth = 0;
    double detail = 1;
    double unit = 1;  // world length of one scene unit
    int objects = 0;
    std::vector<AlarmPlace> places;
    std::uint64_t steep_maps = 0;
    std::uint64_t flat_maps = 0;
    std::uint64_t maps_out_of_range = 0;
    bool operator==(const AlarmBasis&) const = default;
};
[[nodiscard]] AlarmBasis alarm_basis(const CompiledScene& scene, Numeric numeric);

/// What pixels add to the alarms of their picture. A pixel that misses might have met an object as
/// near as any pixel of the picture does: what that means is known when all are there.
struct AlarmSums {
    std::array<std::uint64_t, 8> of_hits{};    // by the bits of PixelAlarm
    std::array<std::uint64_t, 8> of_misses{};  // for other reasons than where they look
    std::uint64_t misses = 0;
    double nearest = std::numeric_limits<double>::infinity();  // hit, scene units

    void add(const AlarmSums& other);
};
/// Marks pixels by what is known of each without the others, and sums that up.
[[nodiscard]] AlarmSums mark_alarms(const AlarmBasis& basis, std::span<PixelRecord> pixels);
/// Marks those of them that miss, by the nearest hit of `sums`.
void mark_misses(const AlarmBasis& basis, const AlarmSums& sums, std::span<PixelRecord> pixels);

/// Every alarm of a picture, also those that count 0.
[[nodiscard]] std::vector<Alarm> alarms_of(const AlarmBasis& basis, const AlarmSums& sums);

/// All of it for a picture that is one frame: its pixels are marked.
[[nodiscard]] std::vector<Alarm> raise_alarms(const CompiledScene& scene, Numeric numeric,
                                              Frame& frame);

/// Counts the pixels anew by their marks, each alarm once a pixel.
void recount(std::vector<Alarm>& alarms, const Frame& marked);

/// The warning, before the first ray, that rays may meet very many cells and be given up: where
/// cells are crowded and cannot be remembered (docs/overlaps.md). Empty where they are not, or can.
[[nodiscard]] std::string crowd_text(const CompiledScene& scene, Numeric numeric);

/// The warning about rays that were given up after `cell_cap` cells; empty if there are none.
[[nodiscard]] std::string cap_text(const RayStatistics& rays, std::uint32_t cell_cap);

/// The lines for stderr: one for each alarm that counts anything.
[[nodiscard]] std::string alarm_text(const std::vector<Alarm>& alarms);

}  // namespace pxm::host
