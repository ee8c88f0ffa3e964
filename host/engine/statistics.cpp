#include "host/engine/statistics.hpp"

#include <algorithm>

namespace pxm::host {

void RayStatistics::add(const RayStatistics& other) {
    pixels += other.pixels;
    eye_rays += other.eye_rays;
    light_rays += other.light_rays;
    reflect_rays += other.reflect_rays;
    hits += other.hits;
    volumes_tested += other.volumes_tested;
    heap_pushes += other.heap_pushes;
    heap_peak = std::max(heap_peak, other.heap_peak);
    heap_overflows += other.heap_overflows;
    restarts += other.restarts;
    capped_rays += other.capped_rays;
}

}  // namespace pxm::host
