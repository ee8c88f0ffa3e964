// From what a node knows of a finished pixel to the frame and the counts of the host. These are the
// emulator's side channels: they use no node memory.
#pragma once

#include "dsp_kernels/pixel_program.hpp"
#include "host/compiled/compiled_scene.hpp"
#include "host/engine/frame.hpp"
#include "host/engine/overflow.hpp"
#include "host/engine/statistics.hpp"
#include "host/engine/word_hash.hpp"
#include "host/node_program/write_scene_block.hpp"

namespace pxm::host {

/// A 24-bit hash of a cell's word (FNV-1a over its symbols), never 0: exact in a float channel.
/// The word is what leads from a scene's object to `object`, and on to the cell.
template <class Real>
[[nodiscard]] std::uint32_t word_hash(const CompiledObject& object,
                                      const kernels::Cell<Real>& cell) {
    std::uint32_t hash = hash_symbols(object.prefix);
    for (std::uint32_t i = 0; i < cell.level; ++i) {
        hash = hash_symbol(hash, cell.word.get(i, cell.bits));
    }
    return finished_hash(hash);
}

/// Writes a finished pixel into the frame and adds its counts.
template <class Real>
void gather_pixel(const CompiledScene& scene, const std::vector<std::uint32_t>& block,
                  const kernels::PixelResult<Real>& result, PixelRecord& pixel,
                  RayStatistics& rays) {
    const bool overflowed = take_overflow<Real>();
    const auto number = [](Real x) { return static_cast<float>(to_double(x)); };
    pixel.color[0] = number(result.color.x);
    pixel.color[1] = number(result.color.y);
    pixel.color[2] = number(result.color.z);
    pixel.volumes = static_cast<std::uint32_t>(result.counts.volumes_tested);
    pixel.heap = static_cast<std::uint32_t>(result.counts.heap_peak);
    pixel.alpha = std::min(number(result.opacity), 1.0F);
    const bool plane = result.floor.plane != 0;
    const bool cell = !plane && result.found.outcome != kernels::Outcome::miss;
    if (plane || cell) {
        const Real t = plane ? result.floor.t : result.found.cell.key;
        pixel.z = static_cast<float>(to_double(t) * scene.unit);
        pixel.normal[0] = number(result.normal.x);
        pixel.normal[1] = number(result.normal.y);
        pixel.normal[2] = number(result.normal.z);
    }
    if (plane) {
        pixel.object = static_cast<std::int32_t>(object_count(scene) +
                                                 plane_index<Real>(block, result.floor.plane));
        pixel.level = 0;
    }
    if (cell) {
        const CompiledObject& object =
            scene.objects[object_index<Real>(block, result.found.cell.object)];
        pixel.object = object.origin;
        pixel.level = static_cast<std::int32_t>(object.prefix.size() + result.found.cell.level);
        pixel.word = word_hash(object, result.found.cell);
    }
    if (result.counts.capped > 0) pixel.alarms |= alarm_capped;
    if (overflowed) pixel.alarms |= alarm_overflow;
    ++rays.pixels;
    rays.eye_rays += scene.samples.size();
    rays.light_rays += result.rays.light;
    rays.reflect_rays += result.rays.reflect;
    rays.hits += plane || cell ? 1 : 0;
    rays.volumes_tested += result.counts.volumes_tested;
    rays.heap_pushes += result.counts.heap_pushes;
    rays.heap_peak = std::max(rays.heap_peak, result.counts.heap_peak);
    rays.heap_overflows += result.counts.heap_overflows;
    rays.restarts += result.counts.restarts;
    rays.capped_rays += result.counts.capped;
}

}  // namespace pxm::host
