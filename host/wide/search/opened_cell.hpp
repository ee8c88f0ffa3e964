// Cells below an entry cell as single rays see them.
#pragma once

#include <cstdint>

#include "host/wide/packet/ray_packet.hpp"
#include "host/wide/search/child_block.hpp"
#include "host/wide/tables/candidate_views.hpp"

namespace pxm::host::wide {

/// Where a cell of homotheties is seen from a ray: for balls the centre beside the ray and its
/// depth, for boxes the depth at which the ray passes the centre's plane across each axis.
struct PlaceBelow {
    float x;
    float y;
    float z;
    float size;  // to the entry cell's
};

/// A cell of homotheties that a ray has opened, and what it met inside.
struct OpenedCell : MetCells {
    alignas(64) float x[room];  // PlaceBelow
    alignas(64) float y[room];
    alignas(64) float z[room];
    alignas(64) float size[room];
    const HomothetyTable* table;
    const std::int32_t* lane;  // of each cell, in the table
    int taken;                 // the cell that was gone into
    std::uint32_t levels_left;
    float constant;  // Lipschitz constant of the composed map
    int set;
    bool in_face;  // the ray lies in the face of a box: floats cannot tell what it meets
};

/// An entry cell as the packet's rays see it, and what the rays below it need.
struct EntryRays {
    alignas(64) float origin[3][packet_rays];
    alignas(64) float direction[3][packet_rays];
    alignas(64) float key[packet_rays];
    alignas(64) float exit[packet_rays];
    int cell = 0;
    int block = -1;  // of its children, once opened
    double base = 0;
};

/// The rays of the packet in the frame of their view.
struct CandidateViewRays {
    alignas(64) float a[packet_rays];  // sideways per depth
    alignas(64) float b[packet_rays];
    alignas(64) float shrink2[packet_rays];  // 1 / (1 + a^2 + b^2)
    alignas(64) float pace[packet_rays];     // depth in this frame per depth in the packet's
    float turn[3][3];                        // the packet's axes in this frame
    CandidateView* candidate_view = nullptr;
    std::uint64_t made_for = 0;  // the packet's number
};

}  // namespace pxm::host::wide
