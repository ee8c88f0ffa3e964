// A cell of homotheties and one ray: which of the children in lanes it meets, and where (Ch. 13).
// The ray's direction is the same in all cells, so a child is met if a circle, or three intervals,
// say so.
#if defined(PXM_HOST_WIDE_SEARCH_HOMOTHETY_CELLS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_HOMOTHETY_CELLS_INL
#undef PXM_HOST_WIDE_SEARCH_HOMOTHETY_CELLS_INL
#else
#define PXM_HOST_WIDE_SEARCH_HOMOTHETY_CELLS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/wide/search/homothety_levels.inl"
#include "host/wide/search/single_ray.inl"
#include "host/wide/tables/candidate_views.hpp"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where a ray is in cells, and which of them it meets.
template <class V, class M>
struct MetLanes {
    LaneInterval<V> inside;
    M met;
};

/// What a ray needs to know of p and of itself, whatever the volumes. Depths are in units of
/// `length` from the entry cell's base.
struct HomothetyRay {
    float pixel_base;
    float pixel_growth;
    float pixel_least;
    float start;      // where the ray begins: keys are no less
    float best;       // no cell beyond is of interest
    float found = 0;  // depth of the terminal cell found

    [[nodiscard]] float pixel(float depth) const {
        return std::max(pixel_base + pixel_growth * depth, pixel_least);
    }
    /// Notes which of the cells from i on, of those that `met` it, it meets not before its start
    /// and nearer than its best, and which are terminal there.
    template <class D, class V, class M>
    HWY_INLINE void note(D d, const ListedCells& cells, int i, MetLanes<V, M> at,
                         OpenedCell& opened) const {
        const V key = hn::Max(at.inside.key, hn::Set(d, start));
        M met =
            hn::And(at.met, hn::And(hn::Le(key, at.inside.exit), hn::Lt(key, hn::Set(d, best))));
        met = hn::And(met, hn::FirstN(d, static_cast<std::size_t>(cells.count - i)));
        const V p = hn::Max(hn::Add(hn::Set(d, pixel_base), hn::Mul(hn::Set(d, pixel_growth), key)),
                            hn::Set(d, pixel_least));
        const V diameter = hn::Mul(hn::Set(d, opened.constant), hn::LoadU(d, cells.diameter + i));
        hn::StoreU(key, d, opened.key + i);
        opened.waiting |= lane_bits(d, met) << i;
        opened.terminal |= lane_bits(d, hn::Le(diameter, p)) << i;
    }
};

/// The places of the cells from i on.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE void keep_places(D d, int i, const Lanes3<V>& center, V size, OpenedCell& opened) {
    hn::StoreU(center.x, d, opened.x + i);
    hn::StoreU(center.y, d, opened.y + i);
    hn::StoreU(center.z, d, opened.z + i);
    hn::StoreU(size, d, opened.size + i);
}

/// Balls: lengths in units of the entry cell's radius.
struct BallRay : HomothetyRay {
    float a;  // the ray moves sideways by (a, b) per depth
    float b;
    float shrink2;  // 1 / (1 + a^2 + b^2)
    const WideScene* scene;
    CandidateView* candidate_view;
    int object;

    [[nodiscard]] bool has_lists() const { return candidate_view->view.shared; }
    HWY_INLINE ListedCells cells_of(const PlaceBelow& at, int set,
                                    const HomothetyTable& table) const {
        const float per_size = -1 / at.size;
        return candidate_view->table(*scene, object, set, table)
            .at(table, at.x * per_size, at.y * per_size);
    }
    HWY_INLINE void test(const PlaceBelow& at, const ListedCells& cells, OpenedCell& opened) const {
        const hn::CappedTag<float, table_step> d;
        using V = hn::VFromD<decltype(d)>;
        const Slant<V> slant{hn::Set(d, a), hn::Set(d, b), hn::Set(d, shrink2)};
        const V size = hn::Set(d, at.size);
        for (int i = 0; i < cells.count; i += static_cast<int>(hn::Lanes(d))) {
            const V qz = hn::LoadU(d, cells.z + i);
            const V beside_x = hn::Sub(hn::LoadU(d, cells.x + i), hn::Mul(slant.a, qz));
            const V beside_y = hn::Sub(hn::LoadU(d, cells.y + i), hn::Mul(slant.b, qz));
            const V x = hn::Add(hn::Set(d, at.x), hn::Mul(size, beside_x));
            const V y = hn::Add(hn::Set(d, at.y), hn::Mul(size, beside_y));
            const V z = hn::Add(hn::Set(d, at.z), hn::Mul(size, qz));
            const V r = hn::Mul(size, hn::LoadU(d, cells.radius + i));
            const BallPass<V> pass(x, y, r, slant);
            const V half = pass.half(slant);
            const V middle = hn::Add(z, pass.ahead);
            const LaneInterval<V> inside{hn::Sub(middle, half), hn::Add(middle, half)};
            const auto met = hn::Le(inside.key, inside.exit);
            keep_places(d, i, Lanes3<V>{x, y, z}, r, opened);
            note(d, cells, i, MetLanes<V, hn::Mask<decltype(d)>>{inside, met}, opened);
        }
    }
    /// Not less than the key of any cell inside.
    [[nodiscard]] static float deepest(const PlaceBelow& at) { return at.z + 1.5F * at.size; }
};

struct BoxRay : HomothetyRay {
    float pace[3];  // depth per unit of each axis
    /// A ray that hardly moves along an axis lies in a face across it if, where it is measured
    /// from, it is nearer to it than so much, in depth; -1 along other axes.
    float room[3] = {};
    float touching = 0;     // of depth, that rounding may part boxes by that touch in an edge
    bool parallel = false;  // to some faces

    /// Fills in what follows from the pace.
    HWY_INLINE void know_faces() {
        constexpr float rounding = 0x1p-20F;  // of the entry cell's half width: where a ray is
        const float x = std::abs(pace[0]), y = std::abs(pace[1]), z = std::abs(pace[2]);
        const float passing = std::min(std::min(x, y), z);
        const float slowest = passing * static_cast<float>(1 / slowest_share);
        touching = 4 * rounding * passing;
        parallel = slowest < std::max(std::max(x, y), z);
        if (!parallel) return;
        for (int k = 0; k < 3; ++k) {
            const float along = std::abs(pace[k]);
            room[k] = slowest < along ? rounding * along + 2 * passing : -1;
        }
    }

    [[nodiscard]] static bool has_lists() { return false; }
    HWY_INLINE static ListedCells cells_of(const PlaceBelow& /*at*/, int /*set*/,
                                           const HomothetyTable& table) {
        return whole_table(table, table.rows);
    }
    HWY_INLINE void test(const PlaceBelow& at, const ListedCells& cells, OpenedCell& opened) const {
        const hn::CappedTag<float, table_step> d;
        using V = hn::VFromD<decltype(d)>;
        for (int i = 0; i < cells.count; i += static_cast<int>(hn::Lanes(d))) {
            const V size = hn::Mul(hn::Set(d, at.size), hn::LoadU(d, cells.radius + i));
            const auto middle = [&](float from, float along, const float* center) HWY_ATTR {
                return hn::Add(hn::Set(d, from),
                               hn::Mul(hn::Set(d, at.size * along), hn::LoadU(d, center + i)));
            };
            const auto half = [&](float along)
                                  HWY_ATTR { return hn::Mul(size, hn::Set(d, std::abs(along))); };
            const V x = middle(at.x, pace[0], cells.x), y = middle(at.y, pace[1], cells.y),
                    z = middle(at.z, pace[2], cells.z);
            const V half_x = half(pace[0]), half_y = half(pace[1]), half_z = half(pace[2]);
            const V key = max3(hn::Sub(x, half_x), hn::Sub(y, half_y), hn::Sub(z, half_z));
            const V exit =
                hn::Min(hn::Min(hn::Add(x, half_x), hn::Add(y, half_y)), hn::Add(z, half_z));
            keep_places(d, i, Lanes3<V>{x, y, z}, size, opened);
            const auto met = hn::Le(key, hn::Add(exit, hn::Set(d, touching)));
            note(d, cells, i, MetLanes<V, hn::Mask<decltype(d)>>{{key, hn::Max(key, exit)}, met},
                 opened);
            if (!parallel) continue;
            const auto near = [&](V center, V reach, float within) HWY_ATTR {
                return hn::Le(hn::Abs(hn::Sub(hn::Abs(center), reach)), hn::Set(d, within));
            };
            const auto here = hn::FirstN(d, static_cast<std::size_t>(cells.count - i));
            const auto in_face = hn::Or(hn::Or(near(x, half_x, room[0]), near(y, half_y, room[1])),
                                        near(z, half_z, room[2]));
            if (!hn::AllFalse(d, hn::And(here, in_face))) opened.in_face = true;
        }
    }
    [[nodiscard]] float deepest(const PlaceBelow& at) const {
        float exit = std::numeric_limits<float>::infinity();
        const float c[3] = {at.x, at.y, at.z};
        for (int k = 0; k < 3; ++k) exit = std::min(exit, c[k] + at.size * std::abs(pace[k]));
        return exit;
    }
};

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
