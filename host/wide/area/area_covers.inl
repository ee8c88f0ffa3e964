// What small cells get of the places that they cover, nearest cell first. As show() of
// dsp_kernels/beam.hpp and dsp_kernels/sight_list.hpp.
#if defined(PXM_HOST_WIDE_AREA_AREA_COVERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_AREA_AREA_COVERS_INL
#undef PXM_HOST_WIDE_AREA_AREA_COVERS_INL
#else
#define PXM_HOST_WIDE_AREA_AREA_COVERS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <functional>

#include "host/wide/area/area_levels.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// When there are more than the list holds, small shares are seen as the cell with the least.
inline void add_sight(PixelBeam& pixel, const BeamSight& sight) {
    if (pixel.sight_count < most_sights) {
        pixel.sights[static_cast<std::size_t>(pixel.sight_count++)] = sight;
        return;
    }
    BeamSight& least = *std::ranges::min_element(pixel.sights, {}, &BeamSight::share);
    const double both = least.share + sight.share;
    if (least.share < sight.share) least = sight;
    least.share = both;
}

/// Gives a cell its part of what is left of the places (Eqs. 18.5, 18.6).
inline void show_cell(const BeamWorkspace& work, PixelBeam& pixel, int cell, std::uint32_t where,
                      double opacity) {
    constexpr double least_part = 1.0 / 64;  // of a place, as in dsp_kernels/beam.hpp
    double sum = 0, x = 0, y = 0;
    for (std::uint32_t rest = where; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        double& left = pixel.left[i];
        double part = left * opacity;
        if (left - part < least_part) part = left;
        left -= part;
        if (!(0 < left)) pixel.open &= ~(std::uint32_t{1} << i);
        sum += part;
        x += part * work.place_x[i];
        y += part * work.place_y[i];
    }
    // In the roundings of the reference kernels: many shares are equal, and the least of them is
    // merged.
    const double inverse = 1 / sum;
    add_sight(pixel, {cell, sum * (1.0 / work.places), x * inverse, y * inverse});
}

/// Shows a small cell in the pixels that see it.
inline void show_in_pixels(const WideScene& scene, BeamWorkspace& work, int index) {
    const BeamCell& cell = work.cells[static_cast<std::size_t>(index)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    const double coverage =
        cell.level == object.levels ? 1 : scene.sets[static_cast<std::size_t>(cell.set)].coverage;
    for (int i = cell.first_place; i < cell.end_place; ++i) {
        const CoveredPlaces& covered = work.covered[static_cast<std::size_t>(i)];
        PixelBeam& pixel = work.pixels[static_cast<std::size_t>(covered.pixel)];
        const std::uint32_t where = covered.places & pixel.open;
        if (where != 0) show_cell(work, pixel, index, where, coverage);
        if (pixel.open == 0) work.open &= ~(std::uint64_t{1} << covered.pixel);
    }
}

inline void search_tile(const WideScene& scene, BeamWorkspace& work) {
    for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
        push_beam_object(scene, work, i);
    }
    while (!work.queue.empty() && work.open != 0) {
        const int index = work.queue.front().second;
        std::pop_heap(work.queue.begin(), work.queue.end(), std::greater<>{});
        work.queue.pop_back();
        BeamCell& cell = work.cells[static_cast<std::size_t>(index)];
        if (cell.terminal) {
            show_in_pixels(scene, work, index);
            continue;
        }
        cell.pixels = pixels_behind(work, cell);
        if (cell.pixels == 0) continue;
        if (cell.axes < 0) {
            open_homotheties(scene, work, index);
        } else {
            open_beam_cell(scene, work, index);
        }
        const bool is_full = work.covered.size() >= most_covered;
        if (scene.cell_cap <= work.tested || is_full) work.given_up = true;
        if (work.given_up) return;
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
