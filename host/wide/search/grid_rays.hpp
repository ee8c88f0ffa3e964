// The rays that walk below an entry cell of boxes in slices (host/wide/search/grid_lanes.inl).
#pragma once

#include <cstdint>

#include "host/wide/packet/ray_packet.hpp"
#include "host/wide/tables/common_grid.hpp"

namespace pxm::host::wide {

/// Rays that go below an entry cell, close together. Depths are from the entry cell's base.
struct GridRays {
    static constexpr int most_lanes = 16;
    static constexpr int room = packet_rays + most_lanes;  // registers are written whole

    alignas(64) float center[3][room];  // depth at which a ray passes the centre's three planes
    alignas(64) float pace[3][room];    // depth per unit of each axis
    alignas(64) float key[room];        // depth at which it enters the cell
    alignas(64) float start[room];      // as in HomothetyRay
    alignas(64) float best[room];
    alignas(64) float pixel_base[room];
    alignas(64) float pixel_growth[room];
    alignas(64) std::int32_t ray[room];  // its number in the packet
    int count = 0;
};

/// The entry cell of a walk, and what all rays have in common.
struct GridEntry {
    const CommonGrid& grid;
    int set;  // as counted there
    float constant;
    std::uint32_t levels_left;
    float pixel_least;
};

}  // namespace pxm::host::wide
