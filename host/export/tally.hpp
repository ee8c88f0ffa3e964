// What is known of the cells before the first of them is written: how many there are and of which
// kinds, the box around them, and what files need to know.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "host/export/export_scene.hpp"
#include "host/output/cloud_extent.hpp"

namespace pxm::host {

/// The end was asked for.
struct ExportStopped {};

/// Hears which share is done, 0 to 1.
using HearShare = std::function<void(double)>;

/// Counts what was visited, for the progress and for signals.
class Watch {
  public:
    Watch(const HearShare& progress, const std::atomic<bool>& stop)
        : progress_(progress), stop_(stop) {}

    /// Of `cells` visits in all; before the first of them.
    void expect(std::uint64_t cells) { expected_ = cells; }
    /// Throws ExportStopped once a signal came, as visit() does now and then.
    void stop_if_asked() const {
        if (stop_) throw ExportStopped{};
    }
    void visit() {
        if ((++visited_ & 0xfffU) == 0) look();
    }

  private:
    void look();

    const HearShare& progress_;
    const std::atomic<bool>& stop_;
    std::uint64_t expected_ = 0;
    std::uint64_t visited_ = 0;
};

/// The cells of one object that end with one set's shape.
struct SetTally {
    std::uint64_t cells = 0;
    bool turned = false;   // some are not along the axes
    bool sheared = false;  // some are no turn, stretch along axes and move
    bool mirrored = false;
    glm::dvec3 low{0.0};  // of their vertices
    glm::dvec3 high{0.0};
};

struct CellTally {
    std::vector<std::vector<SetTally>> systems;  // as those of the scene, and their sets
    std::uint64_t cells = 0;
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
    std::uint64_t triangles = 0;
    glm::dvec3 low{0.0};
    glm::dvec3 high{0.0};
    double smallest = 0;   // the longest side of the box around the smallest cell
    bool colored = false;  // not all of one colour
    CoordinateNumber number = CoordinateNumber::single;
};

/// How many cells, vertices and triangles there are, without a visit. All 0 where words end at a
/// length, which nobody knows before; largest numbers where there are more.
[[nodiscard]] CellTally forecast(const ExportScene& scene);

/// How many cells there are if nothing but the levels ends a word, without visiting them; infinity
/// if that is too many for a double.
[[nodiscard]] double cells_by_levels(const ExportSystem& system);

/// Visits every cell once. Throws Error(ErrorKind::scene) where words do not end, and
/// Error(ErrorKind::setting) if there are more than the scene may have.
[[nodiscard]] CellTally tally_of(const ExportScene& scene, Watch& watch);

/// Calls visit(system, cell) for each cell of every object, with its numbers.
template <class Visit>
void for_each_cell(const ExportScene& scene, Watch& watch, const Visit& visit) {
    for (const ExportSystem& system : scene.systems)
        (void)for_each_cell(system, [&](const Cell& cell) {
            watch.visit();
            visit(system, cell);
        });
}

}  // namespace pxm::host
