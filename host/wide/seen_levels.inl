// The levels of the paths of rays that have hit below the same start cell, a ray in each lane:
// where each ray enters each cell. What the rays share is broadcast; of the other levels each has
// its own.
#if defined(PXM_HOST_WIDE_SEEN_LEVELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEEN_LEVELS_INL
#undef PXM_HOST_WIDE_SEEN_LEVELS_INL
#else
#define PXM_HOST_WIDE_SEEN_LEVELS_INL
#endif

#include <hwy/highway.h>

#include "host/wide/lanes.inl"
#include "host/wide/path.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Takes a ray into a lane: where it goes, and how p grows along it.
inline void take_ray(const WideScene& scene, const RayBundle& bundle, const Path& path, int ray,
                     int lane, SeenTogether& t) {
    const auto growth = static_cast<double>(bundle.pixel1[ray]);
    const double p = static_cast<double>(bundle.pixel0[ray]) + growth * path.start_base;
    const auto start = static_cast<double>(bundle.start[ray]);
    t.beside[0][lane] = bundle.u0[ray];
    t.beside[1][lane] = bundle.u1[ray];
    t.beside[2][lane] = bundle.v0[ray];
    t.beside[3][lane] = bundle.v1[ray];
    t.begin[lane] = bundle.start[ray];
    t.start[lane] = static_cast<float>(start - path.start_base);
    t.pixel_base[lane] = static_cast<float>(scene.detail * p);
    t.pixel_growth[lane] = static_cast<float>(scene.detail * growth);
}

/// The levels of a ray's own, of homotheties: centre and 1 / size seen from the start cell.
inline bool take_own_homotheties(const WideScene& scene, const Workspace& work, const Path& path,
                                 const Found& found, int lane, SeenTogether& t) {
    if (path.shared + found.below_count > Path::capacity) return false;
    const FixedCell& cell = work.fixed_cells[static_cast<std::size_t>(found.start)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    std::array<float, 3> center{};
    float size = 1;
    auto constant = static_cast<float>(cell.constant);
    int set_index = cell.set;
    SeenWord& word = t.words[static_cast<std::size_t>(lane)];
    word = {path.hash, path.color};
    for (int k = 0; k < found.below_count; ++k) {
        const WideSet& set = scene.sets[static_cast<std::size_t>(set_index)];
        const std::size_t child = found.below[static_cast<std::size_t>(k)];
        const HomothetyTable& table = set.children;
        const auto field = [&](int row) { return table.rows.row(row)[child]; };
        for (int axis = 0; axis < 3; ++axis) {
            center[static_cast<std::size_t>(axis)] += size * field(axis);
            t.map[k][axis][lane] = center[static_cast<std::size_t>(axis)];
        }
        size *= field(HomothetyTable::scale);
        t.map[k][3][lane] = 1 / size;
        t.diameter[k][lane] = constant * field(HomothetyTable::diameter);
        constant *= field(HomothetyTable::constant);
        word.hash = hash_symbol(word.hash, static_cast<std::uint32_t>(set.maps[child]));
        if (object.colored) blend(word.color, set.colors[child]);
        set_index = set.sets[child];
    }
    t.levels[lane] = path.shared + found.below_count;
    return true;
}

/// The same of other maps: from the start cell's unit coordinates to the cell's.
inline bool take_own_maps(const WideScene& scene, const Workspace& work, const Path& path,
                          const Found& found, int lane, SeenTogether& t) {
    SeenWord& word = t.words[static_cast<std::size_t>(lane)];
    word = {path.hash, path.color};
    t.levels[lane] = path.shared;
    if (found.block < 0) return true;
    const Block* blocks = work.blocks.data();
    const int own = static_cast<int>(blocks[found.block].level) + 1 - path.shared;
    if (path.shared + own > Path::capacity) return false;
    std::array<std::pair<int, int>, Path::capacity> children;  // and their sets
    int child = found.lane;
    for (int k = own - 1, index = found.block; k >= 0; --k) {
        const Block& block = blocks[index];
        const int stride = scene.sets[static_cast<std::size_t>(block.set)].stride;
        for (int i = 0; i < 12; ++i) t.map[k][i][lane] = block.rows[i * stride + child];
        t.diameter[k][lane] = block.rows[Block::diameter * stride + child];
        children[static_cast<std::size_t>(k)] = {block.set, child};
        child = block.lane;
        index = block.parent;
    }
    const bool colored = scene.objects[static_cast<std::size_t>(path.object)].colored;
    for (int k = 0; k < own; ++k) {
        const auto [set_index, symbol] = children[static_cast<std::size_t>(k)];
        const WideSet& set = scene.sets[static_cast<std::size_t>(set_index)];
        const auto at = static_cast<std::size_t>(symbol);
        word.hash = hash_symbol(word.hash, static_cast<std::uint32_t>(set.maps[at]));
        if (colored) blend(word.color, set.colors[at]);
    }
    t.levels[lane] = path.shared + own;
    return true;
}

enum class PathSide { entry, exit };

template <class D>
HWY_INLINE hn::VFromD<D> load_floats(D d, const float* from) {
    if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
        return hn::LoadU(d, from);
    } else {
        return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D>(), from));
    }
}

template <class D, class V = hn::VFromD<D>>
HWY_INLINE void put_hits(D d, V v, float* to) {
    if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
        hn::StoreU(v, d, to);
    } else {
        const hn::Rebind<float, D> narrow;
        hn::StoreU(hn::DemoteTo(narrow, v), narrow, to);
    }
}

/// A cell as Path has it, for rays in lanes.
template <class V>
struct LevelRows {
    Lanes3<V> u, v, w, o;
    V base, from_start;
};

/// Rays beside the bundle's axis.
template <class V>
struct BesideAxis {
    V u0, u1, v0, v1;
};

template <class V>
struct LevelHits {
    V key, exit;
    Lanes3<V> normal;
};

/// Where rays are in a cell; the normals are those where they enter (leave) it.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LevelHits<V> meet_level(D d, const LevelRows<V>& cell, const BesideAxis<V>& ray,
                                   bool spheres, PathSide side) {
    using T = hn::TFromD<D>;
    const V beside_u = hn::Add(ray.u0, hn::Mul(ray.u1, cell.base));
    const V beside_v = hn::Add(ray.v0, hn::Mul(ray.v1, cell.base));
    const Lanes3<V> origin = add_scaled(add_scaled(cell.o, beside_u, cell.u), beside_v, cell.v);
    const Lanes3<V> direction = add_scaled(add_scaled(cell.w, ray.u1, cell.u), ray.v1, cell.v);
    const LaneInterval<V> inside =
        spheres ? in_unit_ball(d, origin, direction) : in_unit_cube(d, origin, direction);
    const V t = side == PathSide::entry ? inside.key : inside.exit;
    const Lanes3<V> normal =
        spheres ? add_scaled(origin, t, direction) : cube_normal(d, origin, direction, t);
    const Lanes3<V> seen{dot(normal, cell.u), dot(normal, cell.v), dot(normal, cell.w)};
    const V length = hn::Sqrt(dot(seen, seen));
    const V scale = hn::Div(hn::Set(d, T(1)), hn::Max(length, hn::Set(d, T(1e-30))));
    return {hn::Add(cell.from_start, inside.key),
            hn::Add(cell.from_start, inside.exit),
            {hn::Mul(seen.x, scale), hn::Mul(seen.y, scale), hn::Mul(seen.z, scale)}};
}

template <class D, class V>
HWY_INLINE void put_level_hits(D d, const LevelHits<V>& met, int level, int lane, SeenTogether& t) {
    put_hits(d, met.key, t.hits[level][0] + lane);
    put_hits(d, met.exit, t.hits[level][1] + lane);
    put_hits(d, met.normal.x, t.hits[level][2] + lane);
    put_hits(d, met.normal.y, t.hits[level][3] + lane);
    put_hits(d, met.normal.z, t.hits[level][4] + lane);
}

/// A level that rays share; `row` as in Path.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LevelRows<V> shared_rows(D d, const hn::TFromD<D>* row, V from_start) {
    const auto vector = [&](int i) HWY_ATTR {
        return Lanes3<V>{hn::Set(d, row[i]), hn::Set(d, row[i + 1]), hn::Set(d, row[i + 2])};
    };
    return {vector(0), vector(3), vector(6), vector(9), hn::Set(d, row[Path::base]), from_start};
}

template <class D, class V = hn::VFromD<D>>
HWY_INLINE BesideAxis<V> rays_beside(D d, const SeenTogether& t, int lane) {
    const auto beside = [&](int i) HWY_ATTR { return load_floats(d, t.beside[i] + lane); };
    return {beside(0), beside(1), beside(2), beside(3)};
}

/// Where the rays enter the cells that they share; `rows` as in Path, of floats or doubles.
template <int lanes, class T>
inline void meet_shared_levels(const Path& path, const T (*rows)[Path::row_length], bool spheres,
                               SeenTogether& t) {
    const hn::CappedTag<T, lanes> d;
    for (int lane = 0; lane < t.count; lane += static_cast<int>(hn::Lanes(d))) {
        const auto rays = rays_beside(d, t, lane);
        for (int level = 0; level < path.shared; ++level) {
            const auto from_start = hn::Set(d, rows[level][Path::from_start]);
            const auto cell = shared_rows(d, rows[level], from_start);
            put_level_hits(d, meet_level(d, cell, rays, spheres, PathSide::entry), level, lane, t);
        }
    }
}

/// The start cell, the last of the levels that rays share.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LevelRows<V> start_rows(D d, const Path& path) {
    return shared_rows(d, path.rows[path.shared - 1], hn::Zero(d));
}

/// Level k of each ray's own, seen from the bundle.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LevelRows<V> own_rows(D d, const LevelRows<V>& outer, const SeenTogether& t, int k,
                                 int lane) {
    LevelRows<V> cell = outer;
    const auto own = [&](int i) HWY_ATTR { return hn::LoadU(d, t.map[k][i] + lane); };
    if (t.fixed) {
        const V inverse = own(3);
        const auto shrink = [&](const Lanes3<V>& v) HWY_ATTR {
            return Lanes3<V>{hn::Mul(v.x, inverse), hn::Mul(v.y, inverse), hn::Mul(v.z, inverse)};
        };
        cell.u = shrink(outer.u);
        cell.v = shrink(outer.v);
        cell.w = shrink(outer.w);
        cell.o = shrink(
            {hn::Sub(outer.o.x, own(0)), hn::Sub(outer.o.y, own(1)), hn::Sub(outer.o.z, own(2))});
        return cell;
    }
    const Lanes3x3<V> map{
        {{own(0), own(1), own(2)}, {own(3), own(4), own(5)}, {own(6), own(7), own(8)}}};
    cell.u = transform(outer.u, map);
    cell.v = transform(outer.v, map);
    cell.w = transform(outer.w, map);
    cell.o = add(transform(outer.o, map), Lanes3<V>{own(9), own(10), own(11)});
    return cell;
}

/// Where each ray enters the cells of its own, `most` of them. `lanes` is the width of a register:
/// narrow ones are quicker for few rays.
template <int lanes>
inline void meet_own_levels(const Path& path, int most, bool spheres, SeenTogether& t) {
    const hn::CappedTag<float, lanes> d;
    const auto outer = start_rows(d, path);
    for (int lane = 0; lane < t.count; lane += static_cast<int>(hn::Lanes(d))) {
        const auto rays = rays_beside(d, t, lane);
        for (int k = 0; k < most; ++k) {
            put_level_hits(
                d, meet_level(d, own_rows(d, outer, t, k, lane), rays, spheres, PathSide::entry),
                path.shared + k, lane, t);
        }
    }
}

/// Where one ray leaves the last cell of its path, instead of where it enters.
inline void leave_last_level(const Path& path, int lane, bool spheres, SeenTogether& t) {
    const hn::CappedTag<float, 1> d;
    const hn::CappedTag<double, 1> dd;
    const int last = t.levels[lane] - 1;
    if (last >= path.shared) {
        const auto cell = own_rows(d, start_rows(d, path), t, last - path.shared, lane);
        put_level_hits(d, meet_level(d, cell, rays_beside(d, t, lane), spheres, PathSide::exit),
                       last, lane, t);
    } else if (path.deep) {
        const auto cell =
            shared_rows(dd, path.twice[last], hn::Set(dd, path.twice[last][Path::from_start]));
        put_level_hits(dd, meet_level(dd, cell, rays_beside(dd, t, lane), spheres, PathSide::exit),
                       last, lane, t);
    } else {
        const auto cell =
            shared_rows(d, path.rows[last], hn::Set(d, path.rows[last][Path::from_start]));
        put_level_hits(d, meet_level(d, cell, rays_beside(d, t, lane), spheres, PathSide::exit),
                       last, lane, t);
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
