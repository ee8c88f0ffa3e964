// What a picture is cut into where more than one run makes it (host/parts): units, each of which is
// rendered for itself and gives the same pixels and counts whoever renders it, when, and beside
// what. Natively a unit is a rectangle of whole tiles; on the machine it is a node with all of its
// pixels, as the cycles of a pixel are what its node counted since the pixel before.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "host/engine/frame.hpp"
#include "host/engine/statistics.hpp"

namespace pxm::host {

/// The pixels of a unit, row by row: every step_x-th and step_y-th of a window, half open.
struct UnitPixels {
    long x0;          // the first column
    long y0;          // the first row
    long x1;          // beyond the last column
    long y1;          // beyond the last row
    long step_x = 1;  // columns
    long step_y = 1;  // rows

    /// Pixels from left to right.
    [[nodiscard]] long columns() const { return x1 <= x0 ? 0 : (x1 - x0 + step_x - 1) / step_x; }
    /// Pixels from top to bottom.
    [[nodiscard]] long rows() const { return y1 <= y0 ? 0 : (y1 - y0 + step_y - 1) / step_y; }
    /// All of them.
    [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(columns() * rows()); }
};

/// How a window is cut. The same numbers give the same units everywhere.
struct UnitGrid {
    CropWindow window;      // all of it
    long part_side = 0;     // natively: units of one square of the image come one after another
    long side = 0;          // and are no larger than this; both are multiples of tile_side
    long node_columns = 0;  // of the machine; 0: natively
    long node_rows = 0;     // the same

    /// Whether units are nodes of the machine.
    [[nodiscard]] bool of_nodes() const { return node_columns > 0; }
    bool operator==(const UnitGrid&) const = default;
};

/// A native grid with enough units for many parts. Precondition: `part_side` is a multiple of
/// tile_side.
[[nodiscard]] UnitGrid grid_of_tiles(const CropWindow& window, long part_side);

/// The units in their order. On the machine unit k is node k, though it may have no pixels.
[[nodiscard]] std::vector<UnitPixels> units_of(const UnitGrid& grid);

/// A unit that is done.
struct FinishedUnit {
    std::size_t index = 0;                 // in the order of units_of()
    std::span<PixelRecord> pixels;         // row by row
    RayStatistics rays;                    // that were cast for it
    const NodeStatistics* node = nullptr;  // of the machine
};
/// Takes a unit; called from any thread, from several at a time.
using TakeUnit = std::function<void(const FinishedUnit&)>;

}  // namespace pxm::host
