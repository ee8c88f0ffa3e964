// The cells that the beams of a tile's pixels go down to: a cell's children in lanes, each with the
// columns and rows of the picture that it may be seen in. As meet() of dsp_kernels/beam.hpp, but
// the rectangle is one of pixels. In double.
#if defined(PXM_HOST_WIDE_BEAM_LEVELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_BEAM_LEVELS_INL
#undef PXM_HOST_WIDE_BEAM_LEVELS_INL
#else
#define PXM_HOST_WIDE_BEAM_LEVELS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "host/wide/beam_search.hpp"
#include "host/wide/lanes.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The children of a cell in lanes: rows of the scratch table.
struct BeamRows {
    static constexpr int center = 0;  // 3
    static constexpr int key = 3;
    static constexpr int pixels = 4;  // a bit each, whole numbers of 64 bits
    static constexpr int depth = 5;
    static constexpr int over_s = 6;
    static constexpr int near = 7;
    static constexpr int diameter = 8;
    static constexpr int column = 9;
    static constexpr int row = 10;
    static constexpr int shadow = 11;  // 6, see CellShadow
    static constexpr int left = 17;    // the rectangle around, in columns and rows
    static constexpr int right = 18;
    static constexpr int top = 19;
    static constexpr int bottom = 20;
    static constexpr int nearest = 21;  // no point of the cell is nearer
    static constexpr int axes = 22;     // 9
    static constexpr int count = 31;
};

template <class V>
struct LaneReach {
    V x, y, s, z, any;
};

/// The way to the centres of cells: along it their own pixels look.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE Lanes3<V> way_to(D d, const TileView& view, const Lanes3<V>& center) {
    if (!view.perspective) return broadcast(d, &view.along.x);
    const V inverse = hn::Div(hn::Set(d, 1.0), hn::Sqrt(dot(center, center)));
    return {hn::Mul(center.x, inverse), hn::Mul(center.y, inverse), hn::Mul(center.z, inverse)};
}

/// Pixels between two columns (or rows) of the picture, counted from the tile's first.
template <class V>
struct LaneSpan {
    V first, last;
};

/// The pixels that a cell between low and high may be seen in: each looks at places from its corner
/// + `from` to its corner + `to`.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LaneSpan<V> span_of(D d, V low, V high, double from, double to) {
    constexpr double middle = tile_side / 2.0;
    constexpr double last = tile_side - 1.0;
    const V first = hn::Ceil(hn::Add(low, hn::Set(d, middle - to)));
    const V end = hn::Floor(hn::Add(high, hn::Set(d, middle - from)));
    return {hn::Max(first, hn::Zero(d)), hn::Min(end, hn::Set(d, last))};
}

/// The pixels of a rectangle, a bit each; none if it is empty.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE hn::VFromD<hn::RebindToUnsigned<D>> pixels_between(D /*d*/, const LaneSpan<V>& columns,
                                                              const LaneSpan<V>& rows) {
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const auto some = hn::And(hn::Le(columns.first, columns.last), hn::Le(rows.first, rows.last));
    const auto whole = [&](V x) HWY_ATTR {
        return hn::BitCast(du, hn::ConvertTo(di, hn::IfThenElseZero(some, x)));
    };
    const auto x0 = whole(columns.first), x1 = whole(columns.last);
    const auto y0 = whole(rows.first), y1 = whole(rows.last);
    const auto seven = hn::Set(du, 7);
    // A row of ones, once for each row: no carry, as each fits its byte.
    auto one_row = hn::Shl(hn::Shr(hn::Set(du, 0xFF), hn::Add(hn::Sub(seven, x1), x0)), x0);
    one_row = hn::Or(one_row, hn::ShiftLeft<8>(one_row));
    one_row = hn::Or(one_row, hn::ShiftLeft<16>(one_row));
    one_row = hn::Or(one_row, hn::ShiftLeft<32>(one_row));
    const auto missing = hn::ShiftLeft<3>(hn::Add(hn::Sub(seven, y1), y0));
    const auto lines =
        hn::Shl(hn::Shr(hn::Set(du, ~std::uint64_t{0}), missing), hn::ShiftLeft<3>(y0));
    return hn::IfThenElseZero(hn::RebindMask(du, some), hn::And(one_row, lines));
}

/// Where the centres of cells are seen.
template <class V>
struct LanePlace {
    V column, row, over_s;
};

/// Where cells are seen; a cell that is not seen has an empty span of columns.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LanePlace<V> see_cells(D d, const TileView& view, const Lanes3<V>& center,
                                  const LaneReach<V>& reach, V from, double* rows, int stride) {
    const auto row = [&](int i) { return rows + static_cast<std::ptrdiff_t>(i) * stride; };
    const auto along = [&](const glm::dvec3& way, double offset) HWY_ATTR {
        return hn::Add(dot(center, broadcast(d, &way.x)), hn::Set(d, offset));
    };
    const V x = along(view.x, view.x0), y = along(view.y, view.y0), s = along(view.s, view.s0);
    const V depth =
        view.perspective ? hn::Sqrt(dot(center, center)) : along(view.along, view.along0);
    const V near = hn::Sub(s, reach.s), far = hn::Add(s, reach.s);
    const V one = hn::Set(d, 1.0), zero = hn::Zero(d);
    const V over_near = hn::Div(one, near), over_far = hn::Div(one, far);
    const auto around = hn::Le(near, zero);  // the eye: it may be anywhere
    const V anywhere = hn::Set(d, 1e6);
    const auto bounds = [&](V middle, V half) HWY_ATTR {
        const V low = hn::Sub(middle, half), high = hn::Add(middle, half);
        const V first = hn::Mul(low, hn::IfThenElse(hn::Lt(low, zero), over_near, over_far));
        const V last = hn::Mul(high, hn::IfThenElse(hn::Lt(high, zero), over_far, over_near));
        return LaneSpan<V>{hn::IfThenElse(around, hn::Neg(anywhere), first),
                           hn::IfThenElse(around, anywhere, last)};
    };
    const LaneSpan<V> seen_x = bounds(x, reach.x), seen_y = bounds(y, reach.y);
    const LaneSpan<V> columns = span_of(d, seen_x.first, seen_x.last, view.low_x, view.high_x);
    const LaneSpan<V> lines = span_of(d, seen_y.first, seen_y.last, view.low_y, view.high_y);
    const auto ahead = hn::And(hn::Le(from, hn::Add(depth, reach.z)), hn::Lt(zero, far));
    store3(center, d, row(BeamRows::center), stride);
    hn::StoreU(hn::Max(from, hn::Sub(depth, reach.z)), d, row(BeamRows::key));
    const hn::RebindToUnsigned<D> du;
    const auto pixels = pixels_between(d, columns, lines);
    hn::StoreU(hn::BitCast(d, hn::IfThenElseZero(hn::RebindMask(du, ahead), pixels)), d,
               row(BeamRows::pixels));
    hn::StoreU(near, d, row(BeamRows::near));
    hn::StoreU(depth, d, row(BeamRows::depth));
    const V over_s = hn::Div(one, s);
    const LanePlace<V> place{hn::Mul(x, over_s), hn::Mul(y, over_s), over_s};
    hn::StoreU(place.column, d, row(BeamRows::column));
    hn::StoreU(place.row, d, row(BeamRows::row));
    hn::StoreU(over_s, d, row(BeamRows::over_s));
    hn::StoreU(hn::Sub(depth, reach.any), d, row(BeamRows::nearest));
    hn::StoreU(seen_x.first, d, row(BeamRows::left));
    hn::StoreU(seen_x.last, d, row(BeamRows::right));
    hn::StoreU(seen_y.first, d, row(BeamRows::top));
    hn::StoreU(seen_y.last, d, row(BeamRows::bottom));
    return place;
}

/// The shadows of volumes in the picture, in columns and rows from their centres: the points with
///     a x^2 + b x y + c y^2 <= 1       (balls: a, b, c), or
///     |n . (x, y)| <= 1 for three n    (boxes: three times n's coordinates).
/// A half axis reaches that far along X, Y and S.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE void cast_cells(D d, const LanePlace<V>& place, const Lanes3<V>& axes_x,
                           const Lanes3<V>& axes_y, const Lanes3<V>& axes_s, bool ball,
                           double* rows, int stride) {
    const auto aside = [&](V along, V away, V at) HWY_ATTR {
        return hn::Mul(hn::Sub(along, hn::Mul(at, away)), place.over_s);
    };
    const auto of = [&](const Lanes3<V>& along, V at) HWY_ATTR {
        return Lanes3<V>{aside(along.x, axes_s.x, at), aside(along.y, axes_s.y, at),
                         aside(along.z, axes_s.z, at)};
    };
    const Lanes3<V> x = of(axes_x, place.column), y = of(axes_y, place.row);
    const V one = hn::Set(d, 1.0);
    const auto put = [&](int i, V v) HWY_ATTR {
        hn::StoreU(v, d, rows + static_cast<std::ptrdiff_t>(BeamRows::shadow + i) * stride);
    };
    if (ball) {
        const V a = dot(x, x), b = dot(x, y), c = dot(y, y);
        const V inverse = hn::Div(one, hn::Sub(hn::Mul(a, c), hn::Mul(b, b)));
        put(0, hn::Mul(c, inverse));
        put(1, hn::Mul(hn::Set(d, -2.0), hn::Mul(b, inverse)));
        put(2, hn::Mul(a, inverse));
        return;
    }
    const auto area = [&](V ax, V ay, V bx, V by)
                          HWY_ATTR { return hn::Abs(hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx))); };
    const V yz = area(x.y, y.y, x.z, y.z), zx = area(x.z, y.z, x.x, y.x),
            xy = area(x.x, y.x, x.y, y.y);
    // Beside an edge lies all that the other two edges reach.
    const auto edge = [&](int i, V ax, V ay, V reach) HWY_ATTR {
        const V inverse = hn::Div(one, reach);
        put(2 * i, hn::Neg(hn::Mul(ay, inverse)));
        put(2 * i + 1, hn::Mul(ax, inverse));
    };
    edge(0, x.x, y.x, hn::Add(xy, zx));
    edge(1, x.y, y.y, hn::Add(xy, yz));
    edge(2, x.z, y.z, hn::Add(zx, yz));
}

/// How far the half axes go along a functional.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE Lanes3<V> axes_along(D d, const Lanes3x3<V>& axes, const glm::dvec3& way) {
    const Lanes3<V> w = broadcast(d, &way.x);
    return {dot(axes.row[0], w), dot(axes.row[1], w), dot(axes.row[2], w)};
}

/// The shadow of a small cell, as cast_cells() has it.
struct CellShadow {
    float column, row;
    float form[6];
    float spread;  // of the places: p may not be smaller than an object allows
    bool ball;
    bool large;  // so that pixels see it from different sides
};

inline CellShadow shadow_of(const WideScene& scene, const BeamCell& cell, const double* rows,
                            int stride, int lane) {
    const auto at = [&](int i) {
        return static_cast<float>(rows[static_cast<std::ptrdiff_t>(i) * stride + lane]);
    };
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    CellShadow shadow;
    shadow.column = at(BeamRows::column);
    shadow.row = at(BeamRows::row);
    for (int i = 0; i < (object.spheres ? 3 : 6); ++i) {
        shadow.form[i] = at(BeamRows::shadow + i);
    }
    const double depth = rows[static_cast<std::ptrdiff_t>(BeamRows::depth) * stride + lane];
    const double p = scene.camera.pixel_at_eye + scene.camera.pixel_growth * depth;
    shadow.spread = p < object.smallest_pixel ? static_cast<float>(object.smallest_pixel / p) : 1;
    shadow.ball = object.spheres;
    constexpr double most_columns = 1;
    const double half = rows[static_cast<std::ptrdiff_t>(BeamRows::right) * stride + lane] -
                        rows[static_cast<std::ptrdiff_t>(BeamRows::left) * stride + lane];
    shadow.large = most_columns < half;
    return shadow;
}

/// The shadow of a large cell along a pixel's own ray. Its half axes are in the scratch table, or
/// those of its object in its size.
inline void turn_shadow(const WideScene& scene, const BeamWorkspace& work, const BeamCell& cell,
                        const PixelBeam& pixel, int stride, int lane, CellShadow& shadow) {
    const hn::CappedTag<double, 1> d;
    using V = hn::VFromD<decltype(d)>;
    const auto at = [&](int i) {
        return work.scratch.get()[static_cast<std::ptrdiff_t>(i) * stride + lane];
    };
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    glm::dmat3 axes = object.from_unit.linear * cell.size;
    for (int i = 0; i < 9 && !object.fixed_direction && cell.parent >= 0; ++i) {
        axes[i / 3][i % 3] = at(BeamRows::axes + i);
    }
    const Lanes3x3<V> lanes{
        {broadcast(d, &axes[0].x), broadcast(d, &axes[1].x), broadcast(d, &axes[2].x)}};
    const LanePlace<V> place{hn::Set(d, pixel.column), hn::Set(d, pixel.row),
                             hn::Set(d, at(BeamRows::over_s))};
    double rows[BeamRows::shadow + 6];
    cast_cells(d, place, axes_along(d, lanes, work.view.x), axes_along(d, lanes, work.view.y),
               axes_along(d, lanes, work.view.s), object.spheres, rows, 1);
    for (int i = 0; i < 6; ++i) shadow.form[i] = static_cast<float>(rows[BeamRows::shadow + i]);
}

/// The places of a pixel of which `here(d, x, y)` is true, a bit each: where they are from a point
/// of the picture, all `spread` times as far apart.
template <class Here>
HWY_INLINE std::uint32_t places_where(const BeamWorkspace& work, const PixelBeam& beam,
                                      float column, float row, float spread, const Here& here) {
    const hn::CappedTag<float, most_places> d;
    using V = hn::VFromD<decltype(d)>;
    const float right = static_cast<float>(beam.column) - column;
    const float below = static_cast<float>(beam.row) - row;
    const V x0 = hn::Set(d, right), y0 = hn::Set(d, below);
    // p grows with the depth along the pixel's own ray.
    const V apart = hn::Set(d, spread * (1 - beam.deeper_x * right - beam.deeper_y * below));
    std::uint32_t found = 0;
    for (int i = 0; i < work.places; i += static_cast<int>(hn::Lanes(d))) {
        const V x = hn::Add(hn::Mul(hn::Load(d, beam.columns + i), apart), x0);
        const V y = hn::Add(hn::Mul(hn::Load(d, beam.rows + i), apart), y0);
        const auto met =
            hn::And(here(d, x, y), hn::FirstN(d, static_cast<std::size_t>(work.places - i)));
        std::uint8_t bits[8] = {};
        const std::size_t bytes = hn::StoreMaskBits(d, met, bits);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < bytes; ++k) {
            word |= static_cast<std::uint32_t>(bits[k]) << (8 * k);
        }
        found |= word << i;
    }
    return found;
}

/// Those that lie in a shadow.
HWY_INLINE std::uint32_t places_in(const BeamWorkspace& work, const CellShadow& shadow,
                                   std::size_t pixel) {
    const PixelBeam& beam = work.pixels[pixel];
    const float* form = shadow.form;
    if (shadow.ball) {
        return places_where(work, beam, shadow.column, shadow.row, shadow.spread,
                            [&](auto d, auto x, auto y) HWY_ATTR {
                                const auto square =
                                    hn::Add(hn::Mul(x, hn::Add(hn::Mul(hn::Set(d, form[0]), x),
                                                               hn::Mul(hn::Set(d, form[1]), y))),
                                            hn::Mul(hn::Mul(hn::Set(d, form[2]), y), y));
                                return hn::Le(square, hn::Set(d, 1.0F));
                            });
    }
    return places_where(work, beam, shadow.column, shadow.row, shadow.spread,
                        [&](auto d, auto x, auto y) HWY_ATTR {
                            const auto inside = [&](int i) HWY_ATTR {
                                const auto aside = hn::Add(hn::Mul(x, hn::Set(d, form[2 * i])),
                                                           hn::Mul(y, hn::Set(d, form[2 * i + 1])));
                                return hn::Le(hn::Abs(aside), hn::Set(d, 1.0F));
                            };
                            return hn::And(hn::And(inside(0), inside(1)), inside(2));
                        });
}

/// Those in the rectangle around a cell.
HWY_INLINE std::uint32_t places_around(const BeamWorkspace& work, const Outline& outline,
                                       std::size_t pixel) {
    return places_where(work, work.pixels[pixel], outline.column, outline.row, 1,
                        [&](auto d, auto x, auto y) HWY_ATTR {
                            return hn::And(hn::Le(hn::Abs(x), hn::Set(d, outline.columns)),
                                           hn::Le(hn::Abs(y), hn::Set(d, outline.rows)));
                        });
}

/// The pixels that see_cells() found for a cell.
HWY_INLINE std::uint64_t pixels_of(const double* rows, int stride, int lane) {
    return std::bit_cast<std::uint64_t>(
        rows[static_cast<std::ptrdiff_t>(BeamRows::pixels) * stride + lane]);
}

/// detail * p at a depth.
HWY_INLINE double terminal_size(const WideScene& scene, int object, double depth) {
    const double p = scene.camera.pixel_at_eye + scene.camera.pixel_growth * depth;
    return scene.detail *
           std::max(p, scene.objects[static_cast<std::size_t>(object)].smallest_pixel);
}

inline constexpr std::uint32_t most_beam_levels = 120;

/// Lists the open places that a small cell covers. False if there are none.
inline bool find_places(const WideScene& scene, BeamWorkspace& work, BeamCell& cell, int stride,
                        int lane) {
    CellShadow shadow = shadow_of(scene, cell, work.scratch.get(), stride, lane);
    cell.first_place = static_cast<int>(work.covered.size());
    for (std::uint64_t rest = cell.pixels; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        PixelBeam& pixel = work.pixels[static_cast<std::size_t>(i)];
        ++pixel.tested;
        if (shadow.large) turn_shadow(scene, work, cell, pixel, stride, lane, shadow);
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

/// How far a parallelepiped, or a ball that it is the cube of, reaches along a functional.
inline double reach_along(const glm::dmat3& axes, bool ball, const glm::dvec3& way) {
    const glm::dvec3 along{glm::dot(axes[0], way), glm::dot(axes[1], way), glm::dot(axes[2], way)};
    return ball ? glm::length(along) : std::abs(along.x) + std::abs(along.y) + std::abs(along.z);
}

inline BeamReach reach_of(const TileView& view, const glm::dmat3& axes, bool ball) {
    const glm::dvec3 lengths{glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])};
    return {reach_along(axes, ball, view.x), reach_along(axes, ball, view.y),
            reach_along(axes, ball, view.s), reach_along(axes, ball, view.along),
            lengths.x + lengths.y + lengths.z};
}

/// Children of homotheties: a centre and a size.
template <class D>
HWY_INLINE void place_homotheties(D d, const WideScene& scene, BeamWorkspace& work,
                                  const BeamCell& parent, int i) {
    using V = hn::VFromD<D>;
    const WideObject& object = scene.objects[static_cast<std::size_t>(parent.object)];
    const HomothetyTable& table = scene.sets[static_cast<std::size_t>(parent.set)].children;
    const BeamReach& unit = work.reaches[static_cast<std::size_t>(parent.object)];
    const V outer = hn::Set(d, parent.size);
    const Lanes3<V> q = load3(d, table.twice.row(0) + i, table.stride);
    const glm::dmat3& axes = object.from_unit.linear;
    const Lanes3x3<V> turn{
        {broadcast(d, &axes[0].x), broadcast(d, &axes[1].x), broadcast(d, &axes[2].x)}};
    const Lanes3<V> center = add_scaled(broadcast(d, &parent.center.x), outer, transform(q, turn));
    const V size = hn::Mul(outer, hn::LoadU(d, table.twice.row(HomothetyTable::scale) + i));
    const auto reach = [&](double x) HWY_ATTR { return hn::Mul(size, hn::Set(d, x)); };
    double* rows = work.scratch.get() + i;
    V along = size;
    if (object.spheres) {
        along = reach(unit.z);
    } else {
        const Lanes3<V> way = way_to(d, work.view, center);
        along = hn::Mul(
            size, hn::Add(hn::Add(hn::Abs(dot(turn.row[0], way)), hn::Abs(dot(turn.row[1], way))),
                          hn::Abs(dot(turn.row[2], way))));
    }
    const LanePlace<V> place =
        see_cells(d, work.view, center,
                  LaneReach<V>{reach(unit.x), reach(unit.y), reach(unit.s), along, reach(unit.any)},
                  hn::Set(d, parent.large ? 0.0 : parent.key), rows, table.stride);
    const auto axes_along = [&](const glm::dvec3& way) HWY_ATTR {
        return Lanes3<V>{reach(glm::dot(axes[0], way)), reach(glm::dot(axes[1], way)),
                         reach(glm::dot(axes[2], way))};
    };
    cast_cells(d, place, axes_along(work.view.x), axes_along(work.view.y), axes_along(work.view.s),
               object.spheres, rows, table.stride);
}

inline void open_homotheties(const WideScene& scene, BeamWorkspace& work, int index) {
    const hn::ScalableTag<double> d;
    const BeamCell parent = work.cells[static_cast<std::size_t>(index)];
    const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
    const HomothetyTable& table = set.children;
    work.tested += static_cast<std::uint64_t>(table.count);
    for (int i = 0; i < table.count; i += static_cast<int>(hn::Lanes(d))) {
        place_homotheties(d, scene, work, parent, i);
    }
    const double* rows = work.scratch.get();
    const std::uint64_t wanted = parent.pixels;
    const auto row = [&](int i, int lane) {
        return rows[static_cast<std::ptrdiff_t>(i) * table.stride + lane];
    };
    BeamCell child = parent;
    child.parent = index;
    child.level = parent.level + 1;
    for (int lane = 0; lane < table.count; ++lane) {
        child.pixels = pixels_of(rows, table.stride, lane) & wanted;
        if (child.pixels == 0) continue;
        child.center = {row(0, lane), row(1, lane), row(2, lane)};
        child.size = parent.size * table.twice.row(HomothetyTable::scale)[lane];
        child.key = row(BeamRows::key, lane);
        child.constant = parent.constant * table.twice.row(HomothetyTable::constant)[lane];
        child.diameter = parent.constant * table.twice.row(HomothetyTable::diameter)[lane];
        child.set = table.sets[static_cast<std::size_t>(lane)];
        child.lane = lane;
        (void)push_cell(scene, work, child, table.stride, lane);
    }
}

/// How far the children's volumes reach. All but boxes along the axes count as the balls around
/// them, as in dsp_kernels/beam_cell.hpp.
template <class D, class V = hn::VFromD<D>>
class ChildReach {
  public:
    HWY_INLINE ChildReach(D d, const WideSet& set, int i)
        : over_half_(load3(d, set.beams.row(BeamField::inverse_half) + i, set.stride)),
          radius_(hn::Mul(hn::Set(d, 0.5), hn::LoadU(d, set.twice.row(ChildField::diameter) + i))),
          box_(hn::LoadU(d, set.beams.row(BeamField::box) + i)) {}
    /// Given how far the half axes go.
    HWY_INLINE V of(D d, const Lanes3<V>& a) const {
        const Lanes3<V> b{hn::Mul(a.x, over_half_.x), hn::Mul(a.y, over_half_.y),
                          hn::Mul(a.z, over_half_.z)};
        return hn::IfThenElse(hn::Lt(hn::Zero(d), box_),
                              hn::Add(hn::Add(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z)),
                              hn::Mul(radius_, hn::Sqrt(dot(b, b))));
    }

  private:
    Lanes3<V> over_half_;
    V radius_;
    V box_;
};

template <class D, class V = hn::VFromD<D>>
HWY_INLINE V diameters_of_children(D d, const WideSet& set, const BeamCell& parent,
                                   const Lanes3x3<V>& axes, int i) {
    const V diameter = hn::LoadU(d, set.twice.row(ChildField::diameter) + i);
    if (!set.polar) {
        return hn::Mul(diameter, hn::Mul(hn::Set(d, parent.constant),
                                         hn::LoadU(d, set.twice.row(ChildField::constant) + i)));
    }
    // In floats, as shares of the parent's: this is the most that is computed of a child.
    const hn::Rebind<float, D> narrow;
    const double* half = set.beams.row(BeamField::inverse_half) + i;
    const V share = hn::Div(diameter, hn::Set(d, parent.diameter));
    const auto scaled = [&](const Lanes3<V>& row, int k) HWY_ATTR {
        const V h = hn::Mul(share, hn::LoadU(d, half + k * set.stride));
        return Lanes3<hn::VFromD<decltype(narrow)>>{hn::DemoteTo(narrow, hn::Mul(row.x, h)),
                                                    hn::DemoteTo(narrow, hn::Mul(row.y, h)),
                                                    hn::DemoteTo(narrow, hn::Mul(row.z, h))};
    };
    const auto largest = largest_singular_value(
        narrow, Lanes3x3<hn::VFromD<decltype(narrow)>>{
                    {scaled(axes.row[0], 0), scaled(axes.row[1], 1), scaled(axes.row[2], 2)}});
    return hn::Mul(hn::PromoteTo(d, largest), hn::Set(d, parent.diameter));
}

template <class D>
HWY_INLINE void place_children(D d, const BeamWorkspace& work, const WideSet& set,
                               const BeamCell& parent, bool ball, double* rows, int i) {
    using V = hn::VFromD<D>;
    const int stride = set.stride;
    const double* outer = work.axes[static_cast<std::size_t>(parent.axes)].data();
    const double* table = set.beams.row(0) + i;
    const Lanes3x3<V> frame{
        {broadcast(d, outer), broadcast(d, outer + 3), broadcast(d, outer + 6)}};
    const Lanes3x3<V> f = load3x3(d, table, stride);
    const Lanes3x3<V> axes{
        {transform(f.row[0], frame), transform(f.row[1], frame), transform(f.row[2], frame)}};
    const Lanes3<V> center =
        add(broadcast(d, &parent.center.x),
            transform(load3(d, table + BeamField::offset * stride, stride), frame));
    const TileView& view = work.view;
    const ChildReach<D> reach(d, set, i);
    const Lanes3<V> way = way_to(d, view, center);
    const V squares = hn::Add(hn::Add(dot(axes.row[0], axes.row[0]), dot(axes.row[1], axes.row[1])),
                              dot(axes.row[2], axes.row[2]));
    const V lengths = hn::Sqrt(hn::Mul(hn::Set(d, 3.0), squares));  // their sum is no more
    const Lanes3<V> x = axes_along(d, axes, view.x), y = axes_along(d, axes, view.y),
                    s = axes_along(d, axes, view.s);
    const LanePlace<V> place =
        see_cells(d, view, center,
                  LaneReach<V>{reach.of(d, x), reach.of(d, y), reach.of(d, s),
                               reach.of(d, Lanes3<V>{dot(axes.row[0], way), dot(axes.row[1], way),
                                                     dot(axes.row[2], way)}),
                               lengths},
                  hn::Set(d, parent.large ? 0.0 : parent.key), rows + i, stride);
    cast_cells(d, place, x, y, s, ball, rows + i, stride);
    for (int r = 0; r < 3; ++r) {
        store3(axes.row[r], d, rows + (BeamRows::axes + 3 * r) * stride + i, stride);
    }
    hn::StoreU(diameters_of_children(d, set, parent, axes, i), d,
               rows + BeamRows::diameter * stride + i);
}

/// Puts the children of a cell into the queue.
inline void open_beam_cell(const WideScene& scene, BeamWorkspace& work, int index) {
    const hn::ScalableTag<double> d;
    const BeamCell parent = work.cells[static_cast<std::size_t>(index)];
    const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
    const bool ball = scene.objects[static_cast<std::size_t>(parent.object)].spheres;
    double* rows = work.scratch.get();
    work.tested += static_cast<std::uint64_t>(set.count);
    for (int i = 0; i < set.count; i += static_cast<int>(hn::Lanes(d))) {
        place_children(d, work, set, parent, ball, rows, i);
    }
    const std::uint64_t wanted = parent.pixels;
    const auto row = [&](int i, int lane) {
        return rows[static_cast<std::ptrdiff_t>(i) * set.stride + lane];
    };
    BeamCell child = parent;
    child.parent = index;
    child.level = parent.level + 1;
    for (int lane = 0; lane < set.count; ++lane) {
        child.pixels = pixels_of(rows, set.stride, lane) & wanted;
        if (child.pixels == 0) continue;
        child.center = {row(0, lane), row(1, lane), row(2, lane)};
        child.key = row(BeamRows::key, lane);
        child.constant = parent.constant * set.twice.row(ChildField::constant)[lane];
        child.diameter = row(BeamRows::diameter, lane);
        child.set = set.sets[static_cast<std::size_t>(lane)];
        child.lane = lane;
        child.axes = static_cast<int>(work.axes.size());
        if (!push_cell(scene, work, child, set.stride, lane)) continue;
        std::array<double, 9>& axes = work.axes.emplace_back();
        for (int i = 0; i < 9; ++i) {
            axes[static_cast<std::size_t>(i)] = row(BeamRows::axes + i, lane);
        }
    }
}

/// The outermost cell of an object, if a pixel may see it.
inline void push_beam_object(const WideScene& scene, BeamWorkspace& work, int index) {
    const hn::CappedTag<double, 1> d;
    using V = hn::VFromD<decltype(d)>;
    const WideObject& object = scene.objects[static_cast<std::size_t>(index)];
    const glm::dmat3& axes = object.from_unit.linear;
    BeamReach reach = reach_of(work.view, axes, !object.box);
    if (object.fixed_direction) work.reaches[static_cast<std::size_t>(index)] = reach;
    if (!object.box && !object.spheres) {  // seen as the ball around it
        glm::dmat3 around;
        for (int i = 0; i < 3; ++i) {
            around[i] = axes[i] * (object.inverse_half[i] * object.diameter / 2);
        }
        reach = reach_of(work.view, around, true);
    }
    double* rows = work.scratch.get();
    const auto lane = [&](double x) { return hn::Set(d, x); };
    const LanePlace<V> place = see_cells(
        d, work.view, broadcast(d, &object.from_unit.translation.x),
        LaneReach<V>{lane(reach.x), lane(reach.y), lane(reach.s), lane(reach.z), lane(reach.any)},
        hn::Zero(d), rows, 1);
    const Lanes3x3<V> half{
        {broadcast(d, &axes[0].x), broadcast(d, &axes[1].x), broadcast(d, &axes[2].x)}};
    cast_cells(d, place, axes_along(d, half, work.view.x), axes_along(d, half, work.view.y),
               axes_along(d, half, work.view.s), object.spheres, rows, 1);
    ++work.tested;
    BeamCell cell{};
    cell.pixels = pixels_of(rows, 1, 0) & work.open;
    if (cell.pixels == 0) return;
    cell.center = object.from_unit.translation;
    cell.size = 1;
    cell.key = rows[BeamRows::key];
    cell.constant = object.constant;
    cell.diameter = object.constant * object.diameter;
    cell.set = object.set;
    cell.object = index;
    cell.parent = -1;
    cell.axes = -1;
    if (!object.fixed_direction) {
        cell.axes = static_cast<int>(work.axes.size());
        std::array<double, 9>& own = work.axes.emplace_back();
        for (std::size_t i = 0; i < 9; ++i) {
            own[i] = axes[static_cast<int>(i / 3)][static_cast<int>(i % 3)];
        }
    }
    (void)push_cell(scene, work, cell, 1, 0);
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
