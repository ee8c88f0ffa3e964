// What a render must not keep silent about: pixels and maps where its numbers may not be enough
// (docs/alarms.md). Looked for by the host when the frame is there; nodes know nothing of it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/engine/frame.hpp"

namespace pxm::host {

/// The alarms of a picture that comes in parts. Pixels that show nothing are judged by the nearest
/// thing that any pixel shows, so they are counted by what else they have, and told at the end.
class AlarmTally {
  public:
    /// `scene` must outlive it.
    AlarmTally(const CompiledScene& scene, Numeric numeric);

    /// Counts a part. Any thread.
    void add(const Frame& part);
    /// Every alarm of the parts so far, also those that count 0.
    [[nodiscard]] std::vector<Alarm> alarms() const;
    /// Marks the pixels of the whole picture, which was added.
    void mark(Frame& whole) const;

    /// What a number type can hold.
    struct Precision {
        const char* name;
        double step;            // relative error of one operation
        double smallest_share;  // p never falls below this share of an object's diameter
        double steepest;        // condition of a map that half of the digits cannot bear
        double largest;         // whose square is still in range
    };
    /// An object's outermost volume, seen from the eye, in scene units.
    struct Place {
        int origin = 0;       // number of the object in the scene
        double distance = 0;  // of its middle
        double diameter = 0;
        double begin = 0;  // what is nearer, or farther than the end, is not of the object
        double end = 0;
    };

  private:
    /// Pixels by all the bits that they have.
    using Counts = std::array<std::uint64_t, 256>;

    [[nodiscard]] std::uint8_t alarms_of(const PixelRecord& hit) const;
    [[nodiscard]] std::uint8_t alarms_of_misses() const;
    [[nodiscard]] bool is_hit(const PixelRecord& pixel) const {
        return pixel.level >= 0 && pixel.object < objects_;
    }

    const CompiledScene& scene_;
    Precision precision_;
    std::vector<Place> places_;
    int objects_;
    std::mutex mutex_;
    Counts hits_{};                                             // with what their depth says
    Counts misses_{};                                           // without what the nearest hit says
    double nearest_ = std::numeric_limits<double>::infinity();  // of all hits, scene units
};

/// The alarms of a whole picture, whose pixels are marked.
[[nodiscard]] std::vector<Alarm> raise_alarms(const CompiledScene& scene, Numeric numeric,
                                              Frame& frame);

/// Counts the pixels anew by their marks, each alarm once a pixel.
void recount(std::vector<Alarm>& alarms, const Frame& marked);

/// The lines for stderr: one for each alarm that counts anything.
[[nodiscard]] std::string alarm_text(const std::vector<Alarm>& alarms);

}  // namespace pxm::host
