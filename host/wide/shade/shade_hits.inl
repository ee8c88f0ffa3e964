// What rays see of the cells that they have found below the same entry cell (Ch. 17), a ray in each
// lane. The walk along a path checks what the search skipped. As dsp_kernels/shade.hpp and
// lights.hpp.
#if defined(PXM_HOST_WIDE_SHADE_SHADE_HITS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SHADE_SHADE_HITS_INL
#undef PXM_HOST_WIDE_SHADE_SHADE_HITS_INL
#else
#define PXM_HOST_WIDE_SHADE_SHADE_HITS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "host/wide/shade/enclosing.inl"
#include "host/wide/shade/homothety_path_levels.inl"
#include "host/wide/shade/normal_sum.inl"
#include "host/wide/shade/path_levels.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// What came of the walks along the paths, a bit for each lane.
struct WalkedLanes {
    std::uint64_t confirmed = 0;
    std::uint64_t unsure = 0;   // a shared cell is entered so near the ray's start that a float may
                                // take it for behind
    std::uint64_t entered = 0;  // a level gave a normal
};

/// What a level's normal counts for (Ch. 17).
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V weight_of(D d, const PathWeights& weights, V diameter) {
    if (weights.mode == kernels::ShadingMode::low_pass) return diameter;
    if (weights.mode == kernels::ShadingMode::high_pass) {
        return hn::Sub(hn::Set(d, weights.outermost), diameter);
    }
    return hn::Set(d, 1.0F);
}

/// The unit vector along the weighted sum, or along the plain one where nothing has a weight.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE Lanes3<V> total_normal(D d, const Lanes3<V>& weighted, const Lanes3<V>& plain, V total) {
    const auto is_weighted = hn::Lt(hn::Zero(d), total);
    const Lanes3<V> sum{hn::IfThenElse(is_weighted, weighted.x, plain.x),
                        hn::IfThenElse(is_weighted, weighted.y, plain.y),
                        hn::IfThenElse(is_weighted, weighted.z, plain.z)};
    const V length = hn::Sqrt(dot(sum, sum));
    return {hn::Div(sum.x, length), hn::Div(sum.y, length), hn::Div(sum.z, length)};
}

/// The diameters of the cells of a level: one for all, or each ray's own.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE V level_diameter(D d, const Path& path, const HitLanes& t, int level, int lane) {
    if (level < path.shared) return hn::Set(d, path.rows[level][Path::diameter]);
    return hn::LoadU(d, t.diameter[level - path.shared] + lane);
}

/// What the cells of an object's paths count for, and which of them are terminal.
struct PathRules {
    PathWeights weights;
    std::uint32_t last_level;  // cells of this level are terminal whatever their size
    float pixel_least;         // detail * p is not less
};

/// What the cells around the objects give: the walks begin with it.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE EnclosingSums<V> sums_around(D d, const HitLanes& t, int lane) {
    const auto around = [&](int i) HWY_ATTR {
        return t.enclosed ? hn::LoadU(d, t.enclosing[i] + lane) : hn::Zero(d);
    };
    return {{around(0), around(1), around(2)}, {around(3), around(4), around(5)}, around(6)};
}

/// Walks the paths from the objects on. A walk is confirmed if the ray meets every cell within its
/// parent's interval, and the last cell alone is terminal. Leaves the depths and total normals.
template <int lanes>
inline WalkedLanes walk_lanes(const Path& path, const PathRules& rules, int most, HitLanes& t) {
    const hn::CappedTag<float, lanes> d;
    const hn::RebindToSigned<decltype(d)> di;
    using V = hn::VFromD<decltype(d)>;
    const PathWeights& weights = rules.weights;
    const V zero = hn::Zero(d), close = hn::Set(d, 0x1p-16F), one = hn::Set(d, 1.0F);
    WalkedLanes walked;
    for (int lane = 0; lane < t.count; lane += static_cast<int>(hn::Lanes(d))) {
        const V start = hn::LoadU(d, t.start + lane);
        const V pixel_base = hn::LoadU(d, t.pixel_base + lane);
        const V pixel_growth = hn::LoadU(d, t.pixel_growth + lane);
        const auto levels = hn::LoadU(di, t.levels + lane);
        V key = start, exit = hn::Set(d, std::numeric_limits<float>::infinity());
        auto [weighted, plain, total] = sums_around(d, t, lane);
        // Beyond the last ray there is what an earlier one has left there.
        const auto present = hn::FirstN(d, static_cast<std::size_t>(t.count - lane));
        auto confirmed = present;
        auto unsure = hn::Lt(one, zero);
        auto entered = hn::Ne(dot(plain, plain), zero);
        for (int level = 0; level < most; ++level) {
            const auto on = hn::RebindMask(d, hn::Lt(hn::Set(di, level), levels));
            const auto final = hn::RebindMask(d, hn::Eq(hn::Set(di, level + 1), levels));
            const auto hit = [&](int i) HWY_ATTR { return hn::LoadU(d, t.hits[level][i] + lane); };
            const V entry = hit(0), leaving = hit(1);
            const V through = hn::Sub(leaving, entry);
            key = hn::IfThenElse(hn::And(on, hn::Lt(key, entry)), entry, key);
            exit = hn::IfThenElse(hn::And(on, hn::Lt(leaving, exit)), leaving, exit);
            const V diameter = level_diameter(d, path, t, level, lane);
            const V p = hn::Max(hn::Add(pixel_base, hn::Mul(pixel_growth, key)),
                                hn::Set(d, rules.pixel_least));
            const bool last = static_cast<std::uint32_t>(level) == rules.last_level;
            const auto terminal = hn::Le(last ? zero : diameter, p);
            auto right = hn::And(hn::Le(zero, through), hn::Le(key, exit));
            right = hn::AndNot(hn::Xor(terminal, final), right);
            confirmed = hn::And(confirmed, hn::Or(right, hn::Not(on)));
            if (level < path.shared) {
                unsure =
                    hn::Or(unsure, hn::Le(hn::Abs(hn::Sub(entry, start)), hn::Mul(close, through)));
            }
            auto gives = hn::And(on, hn::Lt(start, entry));
            if (weights.mode == kernels::ShadingMode::facet) gives = hn::And(gives, final);
            entered = hn::Or(entered, gives);
            const V weight = hn::IfThenElseZero(gives, weight_of(d, weights, diameter));
            const Lanes3<V> normal{hn::IfThenElseZero(gives, hit(2)),
                                   hn::IfThenElseZero(gives, hit(3)),
                                   hn::IfThenElseZero(gives, hit(4))};
            weighted = add_scaled(weighted, weight, normal);
            plain = add(plain, normal);
            total = hn::Add(total, weight);
        }
        hn::StoreU(key, d, t.depth + lane);
        store3(total_normal(d, weighted, plain, total), d, t.normal[0] + lane,
               HitLanes::most_lanes);
        walked.confirmed |= lane_bits(d, confirmed) << lane;
        walked.unsure |= lane_bits(d, hn::And(unsure, present)) << lane;
        walked.entered |= lane_bits(d, entered) << lane;
    }
    return walked;
}

/// A ray that has walked along its path.
struct WalkedRay {
    const Path& path;
    const PathWeights& weights;
    int lane;
    bool entered;  // a cell gave a normal where the ray came in; otherwise the last one gives that
                   // where it goes out
};

/// How much a ray's cells face a point light.
inline float face_lamp(const WideScene& scene, Workspace& work, const WalkedRay& walked,
                       const CompiledLight& light) {
    const Path& path = walked.path;
    const PathWeights& weights = walked.weights;
    const int lane = walked.lane;
    const bool entered = walked.entered;
    const HitLanes& t = work.hit_lanes;
    const int ray = t.rays[static_cast<std::size_t>(lane)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(path.object)];
    PointLightSum sum(work.packet, ray, to_frame(work.packet, light.place - work.packet.origin));
    find_enclosing(scene, object, work.packet, ray, work.enclosing);
    for (const EnclosingNormal& cell : work.enclosing) {
        sum.add(cell.normal, cell.depth, weights.of(cell.diameter));
    }
    const int last = t.levels[lane] - 1;
    const bool facet = weights.mode == kernels::ShadingMode::facet;
    for (int level = facet || !entered ? last : 0; level <= last; ++level) {
        const auto hit = [&](int i) { return t.hits[level][i][lane]; };
        if (entered && !(t.start[lane] < hit(0))) continue;
        const float diameter = level < path.shared ? path.rows[level][Path::diameter]
                                                   : t.diameter[level - path.shared][lane];
        const float depth = hit(entered ? 0 : 1);
        sum.add({hit(2), hit(3), hit(4)}, path.start_base + static_cast<double>(depth),
                weights.of(diameter));
    }
    return sum.mean();
}

/// Fills in what a ray sees; the walk along its path is confirmed.
template <class Levels>
inline void put_hit(const WideScene& scene, Workspace& work, const WalkedRay& walked,
                    ShadedHit& seen) {
    const auto& [path, weights, lane, entered] = walked;
    HitLanes& t = work.hit_lanes;
    glm::vec3 normal{t.normal[0][lane], t.normal[1][lane], t.normal[2][lane]};
    if (!entered) {
        leave_last_level<Levels>(path, lane, t);
        const auto& hits = t.hits[t.levels[lane] - 1];
        PathWalk sum;
        sum.add({hits[2][lane], hits[3][lane], hits[4][lane]}, 1);
        normal = sum.normal();
    }
    normal = to_scene(work.packet, normal);
    seen.normal = {normal.x, normal.y, normal.z};
    face_lights(scene, normal, seen,
                [&](const CompiledLight& light) { return face_lamp(scene, work, walked, light); });
    const HitWord& word = t.words[static_cast<std::size_t>(lane)];
    seen.color = word.color;
    seen.word = finished_hash(word.hash);
    seen.depth = path.start_base + static_cast<double>(t.depth[lane]);
    seen.object = path.object;
    seen.level = t.levels[lane] - 1;
}

/// Where the rays are in the cells of their paths, and what they find on the way.
template <class Levels, int lanes>
inline WalkedLanes walk_paths(const PathRules& rules, Path& path, HitLanes& t) {
    const int most = *std::max_element(t.levels, t.levels + t.count);
    meet_own_levels<Levels, lanes>(path, most - path.shared, t);
    while (true) {
        if (path.deep) {
            meet_shared_levels<Levels, lanes>(path, path.f64, t);
        } else {
            meet_shared_levels<Levels, lanes>(path, path.rows, t);
        }
        const WalkedLanes walked = walk_lanes<lanes>(path, rules, most, t);
        if (path.deep || walked.unsure == 0) return walked;
        path.deep = true;
    }
}

/// Looks at what the rays in the lanes have found. Returns those whose walk is confirmed.
template <class Levels>
inline std::uint64_t shade_below(const WideScene& scene, Workspace& work, Path& path,
                                 ShadedHit* const* seen) {
    constexpr int few = 4;  // rays
    HitLanes& t = work.hit_lanes;
    const WideObject& object = scene.objects[static_cast<std::size_t>(path.object)];
    t.enclosed = object.enclosing >= 0;
    const float outermost =
        t.enclosed ? static_cast<float>(object.widest) : path.rows[0][Path::diameter];
    const PathRules rules{{scene.shading, outermost},
                          object.levels,
                          static_cast<float>(scene.detail * object.smallest_pixel)};
    if (t.enclosed) take_enclosing(scene, object, work.packet, rules.weights, t);
    const WalkedLanes walked = t.count <= few
                                   ? walk_paths<Levels, few>(rules, path, t)
                                   : walk_paths<Levels, HitLanes::most_lanes>(rules, path, t);
    std::uint64_t confirmed = 0;
    for (int lane = 0; lane < t.count; ++lane) {
        if ((walked.confirmed >> lane & 1) == 0) continue;
        const int ray = t.rays[static_cast<std::size_t>(lane)];
        const bool entered = (walked.entered >> lane & 1) != 0;
        put_hit<Levels>(scene, work, {path, rules.weights, lane, entered}, *seen[ray]);
        confirmed |= std::uint64_t{1} << ray;
    }
    return confirmed;
}

inline std::uint64_t shade_kind(const WideScene& scene, Workspace& work, Path& path,
                                ShadedHit* const* seen) {
    switch (path.kind) {
        case Path::Kind::balls:
            return shade_below<BallLevels>(scene, work, path, seen);
        case Path::Kind::boxes:
            return shade_below<BoxLevels>(scene, work, path, seen);
        case Path::Kind::balls_of_maps:
            return shade_below<MapLevels<true>>(scene, work, path, seen);
        case Path::Kind::boxes_of_maps:
            break;
    }
    return shade_below<MapLevels<false>>(scene, work, path, seen);
}

/// Looks at what the rays of a path have found, some at a time. Returns those whose walk is
/// confirmed.
inline std::uint64_t shade_path(const WideScene& scene, Workspace& work, Path& path,
                                ShadedHit* const* seen) {
    const hn::CappedTag<float, HitLanes::most_lanes> d;
    const auto most = static_cast<int>(hn::Lanes(d));
    HitLanes& t = work.hit_lanes;
    const bool of_homotheties = path.kind == Path::Kind::balls || path.kind == Path::Kind::boxes;
    std::uint64_t confirmed = 0;
    std::uint64_t rays = path.rays;
    while (rays != 0) {
        t.count = 0;
        for (; rays != 0 && t.count < most; rays &= rays - 1) {
            const int ray = std::countr_zero(rays);
            const Found& found = work.found[static_cast<std::size_t>(ray)];
            const bool taken = of_homotheties ? take_own_homotheties(scene, work, path, found, t)
                                              : take_own_maps(scene, work, path, found, t);
            if (taken) take_ray(scene, work.packet, path, ray, t);
        }
        if (t.count > 0) confirmed |= shade_kind(scene, work, path, seen);
    }
    path.rays = 0;
    return confirmed;
}

/// Shades what rays of the packet have found; `seen[ray]` is filled in. Returns those whose walk
/// is confirmed.
inline std::uint64_t shade(const WideScene& scene, Workspace& work, std::uint64_t rays,
                           ShadedHit* const* seen) {
    for (; rays != 0; rays &= rays - 1) {
        const Found& found = work.found[static_cast<std::size_t>(std::countr_zero(rays))];
        const bool of_homotheties = found.below_count >= 0;
        Path* path = of_homotheties ? path_of<HomothetyCells>(scene, work, found.start)
                                    : path_of<MapCells>(scene, work, found.start);
        if (path == nullptr) continue;
        path->rays |= rays & (~rays + 1);
    }
    std::uint64_t confirmed = 0;
    for (std::size_t i = 0; i < work.paths_used; ++i) {
        if (work.paths[i].rays != 0) confirmed |= shade_path(scene, work, work.paths[i], seen);
    }
    return confirmed;
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
