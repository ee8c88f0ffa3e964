// Where a tile's pixels see cells, in lanes: the columns and rows of the picture that a cell may be
// seen in, and the shadow that its volume casts there. As meet() of dsp_kernels/beam.hpp, but the
// rectangle is one of pixels. In double.
#if defined(PXM_HOST_WIDE_AREA_TILE_VIEW_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_AREA_TILE_VIEW_INL
#undef PXM_HOST_WIDE_AREA_TILE_VIEW_INL
#else
#define PXM_HOST_WIDE_AREA_TILE_VIEW_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "host/wide/area/area_search.hpp"
#include "host/wide/packet/lanes.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The children of a cell in lanes: rows of the scratch table.
struct BeamRows {
    static constexpr int center = 0;  // 3
    static constexpr int key = 3;
    static constexpr int first_column = 4;
    static constexpr int last_column = 5;
    static constexpr int first_row = 6;
    static constexpr int last_row = 7;
    static constexpr int diameter = 8;
    static constexpr int column = 9;
    static constexpr int row = 10;
    static constexpr int shadow = 11;  // 15, see CellShadow
    static constexpr int near = 26;
    static constexpr int depth = 27;
    static constexpr int left = 28;  // the rectangle around, in columns and rows
    static constexpr int right = 29;
    static constexpr int top = 30;
    static constexpr int bottom = 31;
    static constexpr int nearest = 32;  // no point of the cell is nearer
    static constexpr int axes = 33;     // 9
    static constexpr int count = 42;
};
static_assert(BeamRows::count <= beam_scratch_rows);

/// The rows of a scratch table from a lane on.
struct LaneRows {
    double* first;
    int stride;

    [[nodiscard]] double* operator[](int i) const {
        return first + static_cast<std::ptrdiff_t>(i) * stride;
    }
};

template <class V>
struct LaneReach {
    V x, y, s, z, any;
};

/// Cells to be seen: their centres, how far they reach, and where their parent begins.
template <class V>
struct LaneCells {
    Lanes3<V> center;
    LaneReach<V> reach;
    V from;
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
    constexpr double rounding = 1e-6;  // of a pixel: cells that touch leave none between them
    const V first = hn::Ceil(hn::Add(low, hn::Set(d, middle - to - rounding)));
    const V end = hn::Floor(hn::Add(high, hn::Set(d, middle - from + rounding)));
    // An empty span stays empty: whole numbers just outside will do.
    return {hn::Min(hn::Max(first, hn::Zero(d)), hn::Set(d, last + 1)),
            hn::Max(hn::Min(end, hn::Set(d, last)), hn::Set(d, -1.0))};
}

/// Where the centres of cells are seen.
template <class V>
struct LanePlace {
    V column, row, over_s;
};

/// Where cells are seen; a cell that is not seen has an empty span of columns.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LanePlace<V> see_cells(D d, const TileView& view, const LaneCells<V>& cells,
                                  const LaneRows& rows) {
    const Lanes3<V>& center = cells.center;
    const LaneReach<V>& reach = cells.reach;
    const V from = cells.from;
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
    store3(center, d, rows[BeamRows::center], rows.stride);
    hn::StoreU(hn::Max(from, hn::Sub(depth, reach.z)), d, rows[BeamRows::key]);
    hn::StoreU(columns.first, d, rows[BeamRows::first_column]);
    hn::StoreU(hn::IfThenElse(ahead, columns.last, hn::Set(d, -1.0)), d,
               rows[BeamRows::last_column]);
    hn::StoreU(lines.first, d, rows[BeamRows::first_row]);
    hn::StoreU(lines.last, d, rows[BeamRows::last_row]);
    hn::StoreU(near, d, rows[BeamRows::near]);
    hn::StoreU(depth, d, rows[BeamRows::depth]);
    const V over_s = hn::Div(one, s);
    const LanePlace<V> place{hn::Mul(x, over_s), hn::Mul(y, over_s), over_s};
    hn::StoreU(place.column, d, rows[BeamRows::column]);
    hn::StoreU(place.row, d, rows[BeamRows::row]);
    hn::StoreU(hn::Sub(depth, reach.any), d, rows[BeamRows::nearest]);
    hn::StoreU(seen_x.first, d, rows[BeamRows::left]);
    hn::StoreU(seen_x.last, d, rows[BeamRows::right]);
    hn::StoreU(seen_y.first, d, rows[BeamRows::top]);
    hn::StoreU(seen_y.last, d, rows[BeamRows::bottom]);
    return place;
}

/// How far the half axes of volumes go along the picture's X, Y and S.
template <class V>
struct AxesInPicture {
    Lanes3<V> x, y, s;
};

template <class V>
HWY_INLINE Lanes3<V> cross(const Lanes3<V>& a, const Lanes3<V>& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
            hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

/// The shadows of volumes in the picture: the lines of sight to points that lie x columns and y
/// rows from their centres', in coordinates in which a volume is the unit ball or the cube
/// [-1,1]^3. For a half axis that reaches as far along X, Y and S as three numbers say, a line's
/// points c have xi . c = x and eta . c = y, with
///     xi = xi0 - x sigma,    eta = eta0 - y sigma:
/// in perspective, what is deeper is seen nearer to the centre. So a line has, exactly,
///     the moment    xi y - eta x = xi0 y - eta0 x    about the centre, and
///     the direction xi x eta = xi0 x eta0 - x (sigma x eta0) - y (xi0 x sigma).
template <class D, class V = hn::VFromD<D>>
HWY_INLINE void cast_cells(D d, const LanePlace<V>& place, const AxesInPicture<V>& axes,
                           const LaneRows& rows) {
    const auto aside = [&](V along, V away, V at) HWY_ATTR {
        return hn::Mul(hn::Sub(along, hn::Mul(at, away)), place.over_s);
    };
    const auto of = [&](const Lanes3<V>& along, V at) HWY_ATTR {
        return Lanes3<V>{aside(along.x, axes.s.x, at), aside(along.y, axes.s.y, at),
                         aside(along.z, axes.s.z, at)};
    };
    const auto put = [&](int i, const Lanes3<V>& v)
                         HWY_ATTR { store3(v, d, rows[BeamRows::shadow + i], rows.stride); };
    const Lanes3<V> xi = of(axes.x, place.column), eta = of(axes.y, place.row);
    const Lanes3<V> sigma{hn::Mul(axes.s.x, place.over_s), hn::Mul(axes.s.y, place.over_s),
                          hn::Mul(axes.s.z, place.over_s)};
    put(0, xi);
    put(3, eta);
    put(6, cross(xi, eta));
    put(9, cross(sigma, eta));
    put(12, cross(xi, sigma));
}

/// How far the half axes go along a functional.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE Lanes3<V> axes_along(D d, const Lanes3x3<V>& axes, const glm::dvec3& way) {
    const Lanes3<V> w = broadcast(d, &way.x);
    return {dot(axes.row[0], w), dot(axes.row[1], w), dot(axes.row[2], w)};
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
