// Highway compiles this file once for every kind of register and picks one at run time.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "host/wide/area/area_search.hpp"

#include <algorithm>

#include "host/engine/word_hash.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "host/wide/area/area_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "host/wide/area/area_covers.inl"
#include "host/wide/area/area_shade.inl"

#if HWY_ONCE
namespace pxm::host::wide {

HWY_EXPORT(search_tile);
HWY_EXPORT(see_along);

void prepare_beams(const WideScene& scene, BeamWorkspace& work) {
    int widest = table_step;
    for (const WideSet& set : scene.sets) widest = std::max(widest, set.stride);
    work.scratch =
        hwy::AllocateAligned<double>(static_cast<std::size_t>(widest * beam_scratch_rows));
    work.reaches.resize(scene.objects.size());
}

void search_beams(const WideScene& scene, BeamWorkspace& work) {
    work.cells.clear();
    work.axes.clear();
    work.covered.clear();
    work.queue.clear();
    work.path.levels = 0;
    work.tested = 0;
    work.given_up = false;
    HWY_DYNAMIC_DISPATCH(search_tile)(scene, work);
}

void see_sight(const WideScene& scene, BeamWorkspace& work, int cell, const LoneRay& ray,
               ShadedHit& seen) {
    HWY_DYNAMIC_DISPATCH(see_along)(scene, work, cell, ray, seen);
}

std::uint32_t beam_word(const WideScene& scene, const BeamWorkspace& work, int cell) {
    std::vector<std::uint32_t> symbols;
    const BeamCell* at = &work.cells[static_cast<std::size_t>(cell)];
    std::uint32_t hash = scene.objects[static_cast<std::size_t>(at->object)].hash;
    while (at->parent >= 0) {
        const BeamCell& parent = work.cells[static_cast<std::size_t>(at->parent)];
        const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
        symbols.push_back(static_cast<std::uint32_t>(set.maps[static_cast<std::size_t>(at->lane)]));
        at = &parent;
    }
    for (std::size_t i = symbols.size(); i > 0; --i) hash = hash_symbol(hash, symbols[i - 1]);
    return finished_hash(hash);
}

}  // namespace pxm::host::wide
#endif
