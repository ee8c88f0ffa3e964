// A cell and the places of the pixels that see it, places in lanes, in float: which of them a small
// cell covers, and whether one that is still open lies behind a cell that is to be opened. As
// places_inside() and places_around() of dsp_kernels/beam.hpp.
#if defined(PXM_HOST_WIDE_AREA_PLACES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_AREA_PLACES_INL
#undef PXM_HOST_WIDE_AREA_PLACES_INL
#else
#define PXM_HOST_WIDE_AREA_PLACES_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <functional>

#include "host/wide/area/tile_view.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The shadow of a small cell, as cast_cells() has it.
struct CellShadow {
    float column, row;
    float xi[3], eta[3];
    float along[3], per_column[3], per_row[3];  // directions of lines of sight
    float spread;  // of the places: p may not be smaller than an object allows
    bool ball;
};

HWY_INLINE CellShadow shadow_of(const WideScene& scene, const BeamCell& cell, const double* rows,
                                int stride, int lane) {
    const auto at = [&](int i) {
        return static_cast<float>(rows[static_cast<std::ptrdiff_t>(i) * stride + lane]);
    };
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    CellShadow shadow;
    shadow.column = at(BeamRows::column);
    shadow.row = at(BeamRows::row);
    for (int i = 0; i < 3; ++i) {
        shadow.xi[i] = at(BeamRows::shadow + i);
        shadow.eta[i] = at(BeamRows::shadow + 3 + i);
        shadow.along[i] = at(BeamRows::shadow + 6 + i);
        shadow.per_column[i] = at(BeamRows::shadow + 9 + i);
        shadow.per_row[i] = at(BeamRows::shadow + 12 + i);
    }
    const double depth = rows[static_cast<std::ptrdiff_t>(BeamRows::depth) * stride + lane];
    const double p = scene.camera.pixel_at_eye + scene.camera.pixel_growth * depth;
    shadow.spread = p < object.smallest_pixel ? static_cast<float>(object.smallest_pixel / p) : 1;
    shadow.ball = object.spheres;
    return shadow;
}

/// A point of the picture from which places are seen, so many times as far apart as they are.
struct SpreadFrom {
    float column, row;
    float spread;
};

/// The places of a pixel of which `here(d, x, y)` is true, a bit each: where they are from a point
/// of the picture.
template <class Here>
HWY_INLINE std::uint32_t places_where(const BeamWorkspace& work, const PixelBeam& beam,
                                      const SpreadFrom& from, const Here& here) {
    const hn::CappedTag<float, most_places> d;
    using V = hn::VFromD<decltype(d)>;
    const float right = static_cast<float>(beam.column) - from.column;
    const float below = static_cast<float>(beam.row) - from.row;
    const V x0 = hn::Set(d, right), y0 = hn::Set(d, below), apart = hn::Set(d, from.spread);
    std::uint32_t found = 0;
    for (int i = 0; i < work.places; i += static_cast<int>(hn::Lanes(d))) {
        const V x = hn::Add(hn::Mul(hn::Load(d, beam.columns + i), apart), x0);
        const V y = hn::Add(hn::Mul(hn::Load(d, beam.rows + i), apart), y0);
        const auto met =
            hn::And(here(d, x, y), hn::FirstN(d, static_cast<std::size_t>(work.places - i)));
        found |= static_cast<std::uint32_t>(lane_bits(d, met)) << i;
    }
    return found;
}

/// Those that lie in a shadow.
HWY_INLINE std::uint32_t places_in(const BeamWorkspace& work, const CellShadow& shadow,
                                   std::size_t pixel) {
    constexpr float outermost = 1 + 0x1p-16F;  // no place is lost between boxes that touch
    return places_where(
        work, work.pixels[pixel], {shadow.column, shadow.row, shadow.spread},
        [&](auto d, auto x, auto y) HWY_ATTR {
            using V = decltype(x);
            const auto moment = [&](int i) HWY_ATTR {
                return hn::Sub(hn::Mul(y, hn::Set(d, shadow.xi[i])),
                               hn::Mul(x, hn::Set(d, shadow.eta[i])));
            };
            const auto along = [&](int i) HWY_ATTR {
                return hn::Sub(hn::Sub(hn::Set(d, shadow.along[i]),
                                       hn::Mul(x, hn::Set(d, shadow.per_column[i]))),
                               hn::Mul(y, hn::Set(d, shadow.per_row[i])));
            };
            const Lanes3<V> m{moment(0), moment(1), moment(2)}, w{along(0), along(1), along(2)};
            if (shadow.ball) return hn::Le(dot(m, m), dot(w, w));
            const auto beside = [&](V of, V one, V other) HWY_ATTR {
                const V reach = hn::Add(hn::Abs(one), hn::Abs(other));
                return hn::Le(hn::Abs(of), hn::Mul(reach, hn::Set(d, outermost)));
            };
            return hn::And(hn::And(beside(m.x, w.y, w.z), beside(m.y, w.z, w.x)),
                           beside(m.z, w.x, w.y));
        });
}

/// Those in the rectangle around a cell.
HWY_INLINE std::uint32_t places_around(const BeamWorkspace& work, const Outline& outline,
                                       std::size_t pixel) {
    return places_where(work, work.pixels[pixel], {outline.column, outline.row, 1},
                        [&](auto d, auto x, auto y) HWY_ATTR {
                            return hn::And(hn::Le(hn::Abs(x), hn::Set(d, outline.columns)),
                                           hn::Le(hn::Abs(y), hn::Set(d, outline.rows)));
                        });
}

/// The pixels of a rectangle, a bit each.
HWY_INLINE std::uint64_t pixels_between(const double* rows, int stride, int lane) {
    const auto at = [&](int i) {
        return static_cast<int>(rows[static_cast<std::ptrdiff_t>(i) * stride + lane]);
    };
    const int x0 = at(BeamRows::first_column), x1 = at(BeamRows::last_column);
    const int y0 = at(BeamRows::first_row), y1 = at(BeamRows::last_row);
    if (x1 < x0 || y1 < y0) return 0;
    constexpr std::uint64_t each_row = 0x0101'0101'0101'0101;
    const std::uint64_t columns = (0xFFU >> (7 - x1 + x0)) << x0;
    const std::uint64_t lines = ~std::uint64_t{0} >> (8 * (7 - y1 + y0)) << (8 * y0);
    return (columns * each_row) & lines;
}

/// detail * p at a depth.
HWY_INLINE double terminal_size(const WideScene& scene, int object, double depth) {
    const double p = scene.camera.pixel_at_eye + scene.camera.pixel_growth * depth;
    return scene.detail *
           std::max(p, scene.objects[static_cast<std::size_t>(object)].smallest_pixel);
}

inline constexpr std::uint32_t most_beam_levels = 120;

/// Lists the open places that a small cell covers. False if there are none.
HWY_INLINE bool find_places(const WideScene& scene, BeamWorkspace& work, BeamCell& cell, int stride,
                            int lane) {
    const CellShadow shadow = shadow_of(scene, cell, work.scratch.get(), stride, lane);
    cell.first_place = static_cast<int>(work.covered.size());
    for (std::uint64_t rest = cell.pixels; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        PixelBeam& pixel = work.pixels[static_cast<std::size_t>(i)];
        ++pixel.tested;
        const std::uint32_t where =
            places_in(work, shadow, static_cast<std::size_t>(i)) & pixel.open;
        if (where != 0 && !(pixel.end < cell.key)) work.covered.push_back({i, where});
    }
    cell.end_place = static_cast<int>(work.covered.size());
    return cell.first_place < cell.end_place;
}

/// The rectangle around a cell, as far as floats tell.
HWY_INLINE Outline outline_of(const BeamWorkspace& work, int stride, int lane) {
    constexpr double rounding = 1e-5;  // of a column
    const double* rows = work.scratch.get();
    const auto at = [&](int i) { return rows[static_cast<std::ptrdiff_t>(i) * stride + lane]; };
    const auto middle = [&](int low, int high) {
        return static_cast<float>((at(low) + at(high)) / 2);
    };
    const auto half = [&](int low, int high) {
        return static_cast<float>((at(high) - at(low)) / 2 + rounding);
    };
    return {middle(BeamRows::left, BeamRows::right), middle(BeamRows::top, BeamRows::bottom),
            half(BeamRows::left, BeamRows::right), half(BeamRows::top, BeamRows::bottom)};
}

/// The pixels that have an open place behind the rectangle around a cell.
inline std::uint64_t pixels_behind(const BeamWorkspace& work, const BeamCell& cell) {
    const std::uint64_t wanted = cell.pixels & work.open;
    std::uint64_t behind = 0;
    for (std::uint64_t rest = wanted; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(rest));
        if ((places_around(work, cell.outline, i) & work.pixels[i].open) != 0) {
            behind |= std::uint64_t{1} << i;
        }
    }
    return behind;
}

/// Puts a cell, whose rows are in the scratch table, into the queue, unless it is a small one that
/// covers no open place.
[[nodiscard]] HWY_INLINE bool push_cell(const WideScene& scene, BeamWorkspace& work, BeamCell& cell,
                                        int stride, int lane) {
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    cell.terminal =
        cell.level == object.levels || cell.diameter <= terminal_size(scene, cell.object, cell.key);
    if (cell.level > most_beam_levels) work.given_up = true;
    const auto at = [&](int i) {
        return work.scratch.get()[static_cast<std::ptrdiff_t>(i) * stride + lane];
    };
    const bool around = !(0 < at(BeamRows::near));
    double first = cell.key;
    if (cell.terminal) {
        if (around) work.given_up = true;  // the eye is in it, or beside it
        if (!find_places(scene, work, cell, stride, lane)) return false;
    } else {
        cell.outline = outline_of(work, stride, lane);
        // What is seen far from its centre may be nearer than its key.
        constexpr float small = 2;  // columns
        cell.large = around || small < cell.outline.columns || small < cell.outline.rows;
        if (cell.large) first = at(BeamRows::nearest);
    }
    work.queue.emplace_back(first, static_cast<int>(work.cells.size()));
    std::push_heap(work.queue.begin(), work.queue.end(), std::greater<>{});
    work.cells.push_back(cell);
    return true;
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
