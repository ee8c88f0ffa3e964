// The first cells that the 64 rays of a packet meet. Three steps, one file each:
//   packet_levels.inl  the packet as a whole goes down to *entry cells* of a few pixels, nearest
//                      first, in double
//   entry_cell.inl     the packet's rays, in lanes, against an entry cell, in float
//   single_ray.inl     each ray that meets it, by itself, with a cell's children in lanes
// A workspace is one thread's; its memory does not grow with the picture, and cells that are too
// small for the pixels of a tile do not fill it: beyond most_shared_cells, or a full arena, the
// rays that have not found anything yet are left to the reference kernels.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "host/wide/packet/ray_packet.hpp"
#include "host/wide/search/cells.hpp"
#include "host/wide/search/child_block.hpp"
#include "host/wide/search/opened_cell.hpp"
#include "host/wide/tables/candidate_views.hpp"
#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

inline constexpr std::size_t most_shared_cells = std::size_t{1} << 17;  // of a packet

/// Orders heaps of waiting cells, (near, cell): the nearest comes first, of equals the least
/// number.
struct IsFarther {
    bool operator()(const std::pair<double, int>& a, const std::pair<double, int>& b) const {
        return a.first > b.first || (a.first == b.first && a.second > b.second);
    }
};

/// One thread's memory for the search of one packet after another.
struct SearchWorkspace {
    void clear_found() {
        for (Found& ray : found) ray.clear();
    }

    RayPacket packet;
    std::vector<SharedCell> cells;
    std::vector<HomothetyCell> homothety_cells;
    std::vector<BoxFrustum> box_frusta;         // per object
    std::vector<std::pair<double, int>> queue;  // (near, cell or ~homothety cell), a heap
    std::vector<Block> blocks;
    Arena arena;
    EntryRays start;
    std::vector<MetChildren> met;                      // of blocks, one below the other
    std::array<OpenedCell, Found::most_below> opened;  // one below the other
    std::vector<LaneTable<double>> turned;             // children's centres in the packet's frame
    std::vector<std::uint64_t> turned_for;             // (packet, turn) they are right for
    std::uint64_t packet_number = 0;
    std::vector<CandidateView>
        candidate_views;  // of the packet itself, of a part of the picture, of each light
    CandidateViewRays candidate_view_rays;
    bool looking = false;  // an entry cell has been given to the rays: `found` is theirs
    std::array<Found, packet_rays> found;
    /// What lies beyond is of no interest to a ray: where it found a cell, or where it ends.
    std::array<double, packet_rays> best;
    double farthest = 0;   // of all rays inside, when last looked for
    bool improved = true;  // since then
    std::uint64_t shared_tests = 0;
    hwy::AlignedFreeUniquePtr<double[]> scratch;  // children of a shared cell, in lanes
};

/// Fills in `found` for the packet in the workspace, on the widest registers there are. False, and
/// nothing filled in, if the packet came to no entry cell: none of its rays meets anything.
[[nodiscard]] bool search_packet(const WideScene& scene, SearchWorkspace& work);

}  // namespace pxm::host::wide
