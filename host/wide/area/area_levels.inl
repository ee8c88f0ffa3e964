// The cells that the beams of a tile's pixels go down to, a cell's children in lanes: centres and
// sizes where all maps are homotheties (Ch. 13), else centres and half axes. In double.
#if defined(PXM_HOST_WIDE_AREA_AREA_LEVELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_AREA_AREA_LEVELS_INL
#undef PXM_HOST_WIDE_AREA_AREA_LEVELS_INL
#else
#define PXM_HOST_WIDE_AREA_AREA_LEVELS_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "host/wide/area/places.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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
    const Lanes3<V> q = load3(d, table.f64.row(0) + i, table.stride);
    const glm::dmat3& axes = object.from_unit.linear;
    const Lanes3x3<V> turn{
        {broadcast(d, &axes[0].x), broadcast(d, &axes[1].x), broadcast(d, &axes[2].x)}};
    const Lanes3<V> center = add_scaled(broadcast(d, &parent.center.x), outer, transform(q, turn));
    const V size = hn::Mul(outer, hn::LoadU(d, table.f64.row(HomothetyTable::scale) + i));
    const auto reach = [&](double x) HWY_ATTR { return hn::Mul(size, hn::Set(d, x)); };
    const LaneRows rows{work.scratch.get() + i, table.stride};
    V along = size;
    if (object.spheres) {
        along = reach(unit.z);
    } else {
        const Lanes3<V> way = way_to(d, work.view, center);
        along = hn::Mul(
            size, hn::Add(hn::Add(hn::Abs(dot(turn.row[0], way)), hn::Abs(dot(turn.row[1], way))),
                          hn::Abs(dot(turn.row[2], way))));
    }
    const LanePlace<V> place = see_cells(
        d, work.view,
        LaneCells<V>{center,
                     {reach(unit.x), reach(unit.y), reach(unit.s), along, reach(unit.any)},
                     hn::Set(d, parent.large ? 0.0 : parent.key)},
        rows);
    const auto axes_along = [&](const glm::dvec3& way) HWY_ATTR {
        return Lanes3<V>{reach(glm::dot(axes[0], way)), reach(glm::dot(axes[1], way)),
                         reach(glm::dot(axes[2], way))};
    };
    cast_cells(
        d, place,
        AxesInPicture<V>{axes_along(work.view.x), axes_along(work.view.y), axes_along(work.view.s)},
        rows);
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
        child.pixels = pixels_between(rows, table.stride, lane) & wanted;
        if (child.pixels == 0) continue;
        child.center = {row(0, lane), row(1, lane), row(2, lane)};
        child.size = parent.size * table.f64.row(HomothetyTable::scale)[lane];
        child.key = row(BeamRows::key, lane);
        child.constant = parent.constant * table.f64.row(HomothetyTable::constant)[lane];
        child.diameter = parent.constant * table.f64.row(HomothetyTable::diameter)[lane];
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
          radius_(hn::Mul(hn::Set(d, 0.5), hn::LoadU(d, set.f64.row(ChildField::diameter) + i))),
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
    const V diameter = hn::LoadU(d, set.f64.row(ChildField::diameter) + i);
    if (!set.polar) {
        return hn::Mul(diameter, hn::Mul(hn::Set(d, parent.constant),
                                         hn::LoadU(d, set.f64.row(ChildField::constant) + i)));
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
                               const BeamCell& parent, int i) {
    using V = hn::VFromD<D>;
    const int stride = set.stride;
    const LaneRows rows{work.scratch.get() + i, stride};
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
    const AxesInPicture<V> seen{axes_along(d, axes, view.x), axes_along(d, axes, view.y),
                                axes_along(d, axes, view.s)};
    const Lanes3<V> ahead{dot(axes.row[0], way), dot(axes.row[1], way), dot(axes.row[2], way)};
    const LanePlace<V> place =
        see_cells(d, view,
                  LaneCells<V>{center,
                               {reach.of(d, seen.x), reach.of(d, seen.y), reach.of(d, seen.s),
                                reach.of(d, ahead), lengths},
                               hn::Set(d, parent.large ? 0.0 : parent.key)},
                  rows);
    cast_cells(d, place, seen, rows);
    for (int r = 0; r < 3; ++r) store3(axes.row[r], d, rows[BeamRows::axes + 3 * r], stride);
    hn::StoreU(diameters_of_children(d, set, parent, axes, i), d, rows[BeamRows::diameter]);
}

/// Puts the children of a cell into the queue.
inline void open_beam_cell(const WideScene& scene, BeamWorkspace& work, int index) {
    const hn::ScalableTag<double> d;
    const BeamCell parent = work.cells[static_cast<std::size_t>(index)];
    const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
    const double* rows = work.scratch.get();
    work.tested += static_cast<std::uint64_t>(set.count);
    for (int i = 0; i < set.count; i += static_cast<int>(hn::Lanes(d))) {
        place_children(d, work, set, parent, i);
    }
    const std::uint64_t wanted = parent.pixels;
    const auto row = [&](int i, int lane) {
        return rows[static_cast<std::ptrdiff_t>(i) * set.stride + lane];
    };
    BeamCell child = parent;
    child.parent = index;
    child.level = parent.level + 1;
    for (int lane = 0; lane < set.count; ++lane) {
        child.pixels = pixels_between(rows, set.stride, lane) & wanted;
        if (child.pixels == 0) continue;
        child.center = {row(0, lane), row(1, lane), row(2, lane)};
        child.key = row(BeamRows::key, lane);
        child.constant = parent.constant * set.f64.row(ChildField::constant)[lane];
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
    if (object.of_homotheties) work.reaches[static_cast<std::size_t>(index)] = reach;
    if (!object.box && !object.spheres) {  // seen as the ball around it
        glm::dmat3 around;
        for (int i = 0; i < 3; ++i) {
            around[i] = axes[i] * (object.inverse_half[i] * object.diameter / 2);
        }
        reach = reach_of(work.view, around, true);
    }
    const LaneRows rows{work.scratch.get(), 1};
    const auto lane = [&](double x) { return hn::Set(d, x); };
    const LanePlace<V> place = see_cells(
        d, work.view,
        LaneCells<V>{broadcast(d, &object.from_unit.translation.x),
                     {lane(reach.x), lane(reach.y), lane(reach.s), lane(reach.z), lane(reach.any)},
                     hn::Zero(d)},
        rows);
    const Lanes3x3<V> half{
        {broadcast(d, &axes[0].x), broadcast(d, &axes[1].x), broadcast(d, &axes[2].x)}};
    cast_cells(d, place,
               AxesInPicture<V>{axes_along(d, half, work.view.x), axes_along(d, half, work.view.y),
                                axes_along(d, half, work.view.s)},
               rows);
    ++work.tested;
    BeamCell cell{};
    cell.pixels = pixels_between(rows.first, 1, 0) & work.open;
    if (cell.pixels == 0) return;
    cell.center = object.from_unit.translation;
    cell.size = 1;
    cell.key = *rows[BeamRows::key];
    cell.constant = object.constant;
    cell.diameter = object.constant * object.diameter;
    cell.set = object.set;
    cell.object = index;
    cell.parent = -1;
    cell.axes = -1;
    if (!object.of_homotheties) {
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
