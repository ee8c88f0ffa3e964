// The levels of the paths of rays that have hit below the same entry cell, a ray in each lane:
// where each ray enters each cell. What the rays share is broadcast; of the other levels each has
// its own.
#if defined(PXM_HOST_WIDE_SHADE_PATH_LEVELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SHADE_PATH_LEVELS_INL
#undef PXM_HOST_WIDE_SHADE_PATH_LEVELS_INL
#else
#define PXM_HOST_WIDE_SHADE_PATH_LEVELS_INL
#endif

#include <hwy/highway.h>

#include "host/wide/packet/lanes.inl"
#include "host/wide/shade/path.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Takes a ray into the next lane: where it goes, and how p grows along it.
inline void take_ray(const WideScene& scene, const RayPacket& packet, const Path& path, int ray,
                     HitLanes& t) {
    const int lane = t.count++;
    t.rays[static_cast<std::size_t>(lane)] = ray;
    const auto growth = static_cast<double>(packet.pixel1[ray]);
    const double p = static_cast<double>(packet.pixel0[ray]) + growth * path.start_base;
    const auto start = static_cast<double>(packet.start[ray]);
    t.beside[0][lane] = packet.u0[ray];
    t.beside[1][lane] = packet.u1[ray];
    t.beside[2][lane] = packet.v0[ray];
    t.beside[3][lane] = packet.v1[ray];
    t.begin[lane] = packet.start[ray];
    t.start[lane] = static_cast<float>(start - path.start_base);
    t.pixel_base[lane] = static_cast<float>(scene.detail * p);
    t.pixel_growth[lane] = static_cast<float>(scene.detail * growth);
}

/// The levels of a ray's own in the next lane: maps from the entry cell's unit coordinates to
/// theirs.
inline bool take_own_maps(const WideScene& scene, const Workspace& work, const Path& path,
                          const Found& found, HitLanes& t) {
    const int lane = t.count;
    HitWord& word = t.words[static_cast<std::size_t>(lane)];
    word = path.word;
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
        const auto [set_index, own_child] = children[static_cast<std::size_t>(k)];
        append(word, scene.sets[static_cast<std::size_t>(set_index)],
               static_cast<std::size_t>(own_child), colored);
    }
    t.levels[lane] = path.shared + own;
    return true;
}

enum class PathSide { entry, exit };

/// A ray so near to a face of a box, in its half widths, is left to the reference kernels: they
/// know in double whether it enters there.
inline constexpr double face_room = 0x1p-12;

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

/// Rays beside the packet's axis.
template <class V>
struct BesideAxis {
    V u0, u1, v0, v1;
};

template <class D, class V = hn::VFromD<D>>
HWY_INLINE BesideAxis<V> rays_beside(D d, const HitLanes& t, int lane) {
    const auto beside = [&](int i) HWY_ATTR { return load_floats(d, t.beside[i] + lane); };
    return {beside(0), beside(1), beside(2), beside(3)};
}

/// Where rays are in a cell, from the entry cell's base; the normals are those where they enter
/// (leave) it, in the packet's frame.
template <class V>
struct LevelHits {
    V key, exit;
    Lanes3<V> normal;
};

/// Levels of any maps, as Path has them: U, V, W, o of balls or boxes.
template <bool spheres>
struct MapLevels {
    template <class V>
    using Rays = BesideAxis<V>;
    template <class V>
    struct Cell {
        Lanes3<V> u, v, w, o;
        V base, from_start;
    };

    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE Rays<V> rays(D d, const Path& /*path*/, const HitLanes& t, int lane) {
        return rays_beside(d, t, lane);
    }
    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE Cell<V> shared(D d, const hn::TFromD<D>* row) {
        return {broadcast(d, row),           broadcast(d, row + 3),
                broadcast(d, row + 6),       broadcast(d, row + 9),
                hn::Set(d, row[Path::base]), hn::Set(d, row[Path::from_start])};
    }
    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE Cell<V> own(D d, const Cell<V>& start, const HitLanes& t, int k, int lane) {
        const auto row = [&](int i) HWY_ATTR { return hn::LoadU(d, t.map[k][i] + lane); };
        const Lanes3x3<V> map{
            {{row(0), row(1), row(2)}, {row(3), row(4), row(5)}, {row(6), row(7), row(8)}}};
        return {transform(start.u, map),
                transform(start.v, map),
                transform(start.w, map),
                add(transform(start.o, map), Lanes3<V>{row(9), row(10), row(11)}),
                start.base,
                start.from_start};
    }
    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE LevelHits<V> meet(D d, const Cell<V>& cell, const Rays<V>& ray,
                                        PathSide side) {
        using T = hn::TFromD<D>;
        const V beside_u = hn::Add(ray.u0, hn::Mul(ray.u1, cell.base));
        const V beside_v = hn::Add(ray.v0, hn::Mul(ray.v1, cell.base));
        const Lanes3<V> origin = add_scaled(add_scaled(cell.o, beside_u, cell.u), beside_v, cell.v);
        const Lanes3<V> direction = add_scaled(add_scaled(cell.w, ray.u1, cell.u), ray.v1, cell.v);
        LaneInterval<V> inside =
            spheres ? in_unit_ball(d, origin, direction) : in_unit_cube(d, origin, direction);
        if constexpr (!spheres) {
            const V room = hn::Set(d, static_cast<T>(face_room));
            const auto in_face = in_cube_face(d, origin, direction, {room, room, room});
            inside.key = hn::IfThenElse(in_face, hn::NaN(d), inside.key);
        }
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
};

template <class D, class V>
HWY_INLINE void put_level_hits(D d, const LevelHits<V>& met, int level, int lane, HitLanes& t) {
    put_hits(d, met.key, t.hits[level][0] + lane);
    put_hits(d, met.exit, t.hits[level][1] + lane);
    put_hits(d, met.normal.x, t.hits[level][2] + lane);
    put_hits(d, met.normal.y, t.hits[level][3] + lane);
    put_hits(d, met.normal.z, t.hits[level][4] + lane);
}

/// Where the rays enter the cells that they share; `rows` as in Path, of floats or doubles.
template <class Levels, int lanes, class T>
inline void meet_shared_levels(const Path& path, const T (*rows)[Path::row_length], HitLanes& t) {
    const hn::CappedTag<T, lanes> d;
    for (int lane = 0; lane < t.count; lane += static_cast<int>(hn::Lanes(d))) {
        const auto rays = Levels::rays(d, path, t, lane);
        for (int level = 0; level < path.shared; ++level) {
            const auto cell = Levels::shared(d, rows[level]);
            put_level_hits(d, Levels::meet(d, cell, rays, PathSide::entry), level, lane, t);
        }
    }
}

/// Where each ray enters the cells of its own, `most` of them. `lanes` is the width of a register:
/// narrow ones are quicker for few rays.
template <class Levels, int lanes>
inline void meet_own_levels(const Path& path, int most, HitLanes& t) {
    const hn::CappedTag<float, lanes> d;
    const auto start = Levels::shared(d, path.rows[path.shared - 1]);
    for (int lane = 0; lane < t.count; lane += static_cast<int>(hn::Lanes(d))) {
        const auto rays = Levels::rays(d, path, t, lane);
        for (int k = 0; k < most; ++k) {
            const auto cell = Levels::own(d, start, t, k, lane);
            put_level_hits(d, Levels::meet(d, cell, rays, PathSide::entry), path.shared + k, lane,
                           t);
        }
    }
}

/// Where one ray leaves the last cell of its path, instead of where it enters.
template <class Levels>
inline void leave_last_level(const Path& path, int lane, HitLanes& t) {
    const hn::CappedTag<float, 1> d;
    const hn::CappedTag<double, 1> dd;
    const int last = t.levels[lane] - 1;
    const auto leave = [&](auto tag, const auto& cell) HWY_ATTR {
        const auto rays = Levels::rays(tag, path, t, lane);
        put_level_hits(tag, Levels::meet(tag, cell, rays, PathSide::exit), last, lane, t);
    };
    if (last >= path.shared) {
        const auto start = Levels::shared(d, path.rows[path.shared - 1]);
        leave(d, Levels::own(d, start, t, last - path.shared, lane));
    } else if (path.deep) {
        leave(dd, Levels::shared(dd, path.f64[last]));
    } else {
        leave(d, Levels::shared(d, path.rows[last]));
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
