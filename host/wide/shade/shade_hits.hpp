// What the rays of a packet see of what they have found, a ray in each lane (shade_hits.inl).
#pragma once

#include <cstdint>
#include <vector>

#include "host/wide/search/packet_search.hpp"
#include "host/wide/shade/enclosing.hpp"
#include "host/wide/shade/hit.hpp"
#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

/// One thread's memory: that of the search, and paths to what was found.
struct Workspace : SearchWorkspace {
    std::vector<Path> paths;
    std::size_t paths_used = 0;
    std::uint64_t paths_of = 0;  // the packet that they are of
    HitLanes hit_lanes;
    std::vector<EnclosingNormal> enclosing;  // of the ray that is being looked at
};

/// Looks at what rays of the packet have found, a bit each, and fills in `seen[ray]`. Returns those
/// whose walk along the path confirms it in float: of the others the reference kernels are to
/// judge.
[[nodiscard]] std::uint64_t shade_hits(const WideScene& scene, Workspace& work, std::uint64_t rays,
                                       ShadedHit* const* seen);

}  // namespace pxm::host::wide
