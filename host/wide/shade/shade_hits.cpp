// Highway compiles this file once for every kind of register and picks one at run time.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "host/wide/shade/shade_hits.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "host/wide/shade/shade_hits.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "host/wide/shade/shade_hits.inl"

#if HWY_ONCE
namespace pxm::host::wide {

HWY_EXPORT(shade);

std::uint64_t shade_hits(const WideScene& scene, Workspace& work, std::uint64_t rays,
                         ShadedHit* const* seen) {
    if (work.paths_of != work.packet_number) {
        work.paths_of = work.packet_number;
        work.paths_used = 0;
    }
    return HWY_DYNAMIC_DISPATCH(shade)(scene, work, rays, seen);
}

}  // namespace pxm::host::wide
#endif
