// The cells that the rays of a packet share, and what a ray was found to meet first.
#pragma once

#include <array>
#include <cstdint>

#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

/// A cell that the packet's rays share, as seen from the packet. A point of a ray at depth z is
/// o + (z - base) W + u U + v V in the cell's unit coordinates; o is near the volume's centre.
struct SharedCell {
    std::array<double, 12> rows;   // U, V, W, o
    std::array<double, 9> linear;  // composed linear part (polar)
    double constant = 1;           // Lipschitz constant of the composed map (otherwise)
    double diameter = 0;           // in scene units
    double base = 0;
    double near = 0;  // all rays of the packet are within this interval of depths
    double far = 0;   // while they are in the cell
    int set = 0;
    int object = 0;
    int parent = -1;
    int lane = 0;  // in the parent's set
    std::uint32_t level = 0;
    bool spheres = true;  // its own volume
    int path = -1;        // index of its path, once a ray has hit below it
};

/// A shared cell of homotheties: its centre and its size. For balls in the packet's frame and scene
/// units, z along the axis; for boxes in the unit coordinates of the object.
struct HomothetyCell {
    std::array<double, 3> center;
    double size;
    double near;
    double far;
    double constant;
    double diameter;
    int set;
    int object;
    int parent;
    int lane;  // in the parent's set
    std::uint32_t level;
    int path;
};

/// What the shared cells of an object of boxes have in common, as seen from the packet. Along each
/// axis k a ray is at eye[k] + z w[k], more or less spread0[k] + z spread1[k]; kept of the paces
/// are 1 / (w - spread1) and 1 / (-w - spread1).
struct BoxFrustum {
    std::array<double, 3> eye, spread0, high_pace, low_pace;
};

/// What a ray was found to meet first: the cell in `lane` of `block`, or the entry cell itself.
struct Found {
    int start = -1;  // index of a shared cell; -1: nothing
    int block = -1;
    int lane = 0;
    double depth = 0;
    std::uint32_t tested = 0;  // volumes tested for this ray alone
    bool given_up =
        false;  // too many of them, or it lies in the face of a box: for the reference kernels

    /// Nothing found yet; `below` is left as it is.
    void clear() {
        start = -1;
        block = -1;
        depth = 0;
        tested = 0;
        given_up = false;
        below_count = -1;
    }
    // Below an entry cell of homotheties (`start` is a cell of homotheties), instead of a block:
    // lanes in the sets' tables.
    static constexpr int most_below = most_levels_below;
    int below_count = -1;  // -1: a block and a lane
    std::array<std::uint16_t, most_below> below;
};

}  // namespace pxm::host::wide
