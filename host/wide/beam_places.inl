// A small cell and the beams of the pixels that see it: which of a pixel's places it covers, places
// in lanes, and what it gets of them. As places_inside() and show() of dsp_kernels/beam.hpp and
// dsp_kernels/sight_list.hpp.
#if defined(PXM_HOST_WIDE_BEAM_PLACES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_BEAM_PLACES_INL
#undef PXM_HOST_WIDE_BEAM_PLACES_INL
#else
#define PXM_HOST_WIDE_BEAM_PLACES_INL
#endif

#include <hwy/highway.h>

#include <bit>
#include <cmath>

#include "host/wide/beam_levels.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A small cell in the tile's picture, lengths divided by S.
struct SmallCell {
    double column, row;  // of its centre
    float pixel;         // p at its centre
    glm::dvec2 axes[3];  // how far its half axes reach in columns and rows, seen along the ray
                         // through (column, row)
};

inline SmallCell small_cell(const WideScene& scene, const BeamWorkspace& work,
                            const BeamCell& cell) {
    const TileView& view = work.view;
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    const double over_s = 1 / (glm::dot(cell.center, view.s) + view.s0);
    const double depth = view.perspective ? glm::length(cell.center)
                                          : glm::dot(cell.center, view.along) + view.along0;
    SmallCell small;
    small.column = (glm::dot(cell.center, view.x) + view.x0) * over_s;
    small.row = (glm::dot(cell.center, view.y) + view.y0) * over_s;
    small.pixel =
        static_cast<float>(terminal_size(scene, cell.object, depth) / scene.detail * over_s);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis = object.from_unit.linear[i] * cell.size;
        if (cell.axes >= 0) {
            const double* own = work.axes[static_cast<std::size_t>(cell.axes)].data() + 3 * i;
            axis = {own[0], own[1], own[2]};
        }
        const double away = glm::dot(axis, view.s);
        small.axes[i] = glm::dvec2{glm::dot(axis, view.x) - small.column * away,
                                   glm::dot(axis, view.y) - small.row * away} *
                        over_s;
    }
    return small;
}

/// The volume of a cell beside the ray of a pixel: all that lies within
///     xx x^2 + xy x y + yy y^2 <= 1   (balls), or
///     |normal . (x, y)| <= 1          (boxes, three normals)
/// of its centre.
struct CellShadow {
    float x, y;  // of the centre, from the first place's ray
    float xx = 0, xy = 0, yy = 0;
    float normal_x[3], normal_y[3];
};

inline CellShadow shadow_of(const SmallCell& small, const PixelBeam& pixel, bool ball) {
    const auto beside = [&](double columns, double rows) {
        return glm::dvec2{pixel.xx * columns + pixel.xy * rows, pixel.yy * rows};
    };
    const glm::dvec2 center = beside(small.column - pixel.column, small.row - pixel.row);
    glm::dvec2 g[3];
    for (int i = 0; i < 3; ++i) g[i] = beside(small.axes[i].x, small.axes[i].y);
    CellShadow shadow{};
    shadow.x = static_cast<float>(center.x);
    shadow.y = static_cast<float>(center.y);
    if (ball) {
        const double a = g[0].x * g[0].x + g[1].x * g[1].x + g[2].x * g[2].x;
        const double b = g[0].x * g[0].y + g[1].x * g[1].y + g[2].x * g[2].y;
        const double c = g[0].y * g[0].y + g[1].y * g[1].y + g[2].y * g[2].y;
        const double inverse = 1 / (a * c - b * b);
        shadow.xx = static_cast<float>(c * inverse);
        shadow.xy = static_cast<float>(-2 * b * inverse);
        shadow.yy = static_cast<float>(a * inverse);
        return shadow;
    }
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x * b.y - a.y * b.x;
    };
    const double areas[3] = {std::abs(cross(g[1], g[2])), std::abs(cross(g[2], g[0])),
                             std::abs(cross(g[0], g[1]))};
    for (int i = 0; i < 3; ++i) {  // beside an edge lie all points within the other two's reach
        const double inverse = 1 / (areas[(i + 1) % 3] + areas[(i + 2) % 3]);
        shadow.normal_x[i] = static_cast<float>(-g[i].y * inverse);
        shadow.normal_y[i] = static_cast<float>(g[i].x * inverse);
    }
    return shadow;
}

/// The places of a pixel that lie in the shadow, a bit each.
inline std::uint32_t places_in(const BeamWorkspace& work, const CellShadow& shadow, float pixel,
                               bool ball) {
    const hn::CappedTag<float, most_places> d;
    using V = hn::VFromD<decltype(d)>;
    const V size = hn::Set(d, pixel), one = hn::Set(d, 1.0F);
    std::uint32_t inside = 0;
    for (int i = 0; i < work.places; i += static_cast<int>(hn::Lanes(d))) {
        const V x = hn::Sub(hn::Mul(hn::Load(d, work.place_x + i), size), hn::Set(d, shadow.x));
        const V y = hn::Sub(hn::Mul(hn::Load(d, work.place_y + i), size), hn::Set(d, shadow.y));
        auto here = hn::FirstN(d, static_cast<std::size_t>(work.places - i));
        if (ball) {
            const V square = hn::Add(hn::Mul(x, hn::Add(hn::Mul(hn::Set(d, shadow.xx), x),
                                                        hn::Mul(hn::Set(d, shadow.xy), y))),
                                     hn::Mul(hn::Mul(hn::Set(d, shadow.yy), y), y));
            here = hn::And(here, hn::Le(square, one));
        } else {
            for (int k = 0; k < 3; ++k) {
                const V aside = hn::Add(hn::Mul(x, hn::Set(d, shadow.normal_x[k])),
                                        hn::Mul(y, hn::Set(d, shadow.normal_y[k])));
                here = hn::And(here, hn::Le(hn::Abs(aside), one));
            }
        }
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(d, here, bits);
        std::uint32_t word = 0;
        for (int k = 0; k < 4; ++k) word |= static_cast<std::uint32_t>(bits[k]) << (8 * k);
        inside |= word << i;
    }
    return inside;
}

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
        x += part * static_cast<double>(work.place_x[i]);
        y += part * static_cast<double>(work.place_y[i]);
    }
    add_sight(pixel, {cell, sum / work.places, x / sum, y / sum});
}

/// Shows a small cell in the pixels that see it.
inline void show_in_pixels(const WideScene& scene, BeamWorkspace& work, int index) {
    const BeamCell cell = work.cells[static_cast<std::size_t>(index)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    const SmallCell small = small_cell(scene, work, cell);
    const double coverage =
        cell.level == object.levels ? 1 : scene.sets[static_cast<std::size_t>(cell.set)].coverage;
    for (std::uint64_t rest = cell.pixels & work.open; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        PixelBeam& pixel = work.pixels[static_cast<std::size_t>(i)];
        ++pixel.tested;
        const CellShadow shadow = shadow_of(small, pixel, object.spheres);
        const std::uint32_t where =
            pixel.end < cell.key
                ? 0
                : places_in(work, shadow, small.pixel, object.spheres) & pixel.open;
        if (where != 0) show_cell(work, pixel, index, where, coverage);
        if (pixel.open == 0 || pixel.end < cell.key) work.open &= ~(std::uint64_t{1} << i);
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
        const BeamCell& cell = work.cells[static_cast<std::size_t>(index)];
        if ((cell.pixels & work.open) == 0) continue;
        if (cell.terminal) {
            show_in_pixels(scene, work, index);
        } else if (cell.axes < 0) {
            open_homotheties(scene, work, index);
        } else {
            open_beam_cell(scene, work, index);
        }
        if (scene.cell_cap <= work.tested) work.given_up = true;
        if (work.given_up) return;
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
