// The levels of the paths of rays that have hit below the same entry cell, where all cells are
// balls or all are boxes and no map turns: a cell is a centre and a size, and what does not change
// from level to level is found once. path_levels.inl does the same for all other maps.
#if defined(PXM_HOST_WIDE_SHADE_HOMOTHETY_PATH_LEVELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SHADE_HOMOTHETY_PATH_LEVELS_INL
#undef PXM_HOST_WIDE_SHADE_HOMOTHETY_PATH_LEVELS_INL
#else
#define PXM_HOST_WIDE_SHADE_HOMOTHETY_PATH_LEVELS_INL
#endif

#include <hwy/highway.h>

#include "host/wide/shade/path.inl"
#include "host/wide/shade/path_levels.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where the children of a set are: of balls in the packet's frame, of boxes in the object's.
struct ChildPlaces {
    int set = -1;
    const HomothetyTable* table = nullptr;
    const double* x = nullptr;
    const double* y = nullptr;
    const double* z = nullptr;
};

inline ChildPlaces child_places(const WideScene& scene, Workspace& work, int object, int set) {
    const HomothetyTable& table = scene.sets[static_cast<std::size_t>(set)].children;
    const LaneTable<double>& centers = scene.objects[static_cast<std::size_t>(object)].spheres
                                           ? turn_children(scene, work, object, set)
                                           : table.f64;
    return {set, &table, centers.row(0), centers.row(1), centers.row(2)};
}

/// The levels of a ray's own in the next lane: where they are from the entry cell, and how large.
inline bool take_own_homotheties(const WideScene& scene, Workspace& work, const Path& path,
                                 const Found& found, HitLanes& t) {
    if (path.shared + found.below_count > Path::capacity) return false;
    const int lane = t.count;
    const HomothetyCell& start = work.homothety_cells[static_cast<std::size_t>(found.start)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(start.object)];
    HitWord& word = t.words[static_cast<std::size_t>(lane)];
    word = path.word;
    float x = 0, y = 0, z = 0, size = static_cast<float>(start.size);
    auto constant = static_cast<float>(start.constant);
    int set_index = start.set;
    ChildPlaces places;
    for (int k = 0; k < found.below_count; ++k) {
        if (set_index != places.set) places = child_places(scene, work, start.object, set_index);
        const std::size_t child = found.below[static_cast<std::size_t>(k)];
        x += size * static_cast<float>(places.x[child]);
        y += size * static_cast<float>(places.y[child]);
        z += size * static_cast<float>(places.z[child]);
        size *= places.table->rows.row(HomothetyTable::scale)[child];
        t.map[k][0][lane] = x;
        t.map[k][1][lane] = y;
        t.map[k][2][lane] = z;
        t.map[k][3][lane] = size;
        t.diameter[k][lane] = constant * places.table->rows.row(HomothetyTable::diameter)[child];
        constant *= places.table->rows.row(HomothetyTable::constant)[child];
        const WideSet& set = scene.sets[static_cast<std::size_t>(set_index)];
        append(word, set, child, object.colored);
        set_index = set.sets[child];
    }
    t.levels[lane] = path.shared + found.below_count;
    return true;
}

/// Balls, in the packet's frame and scene units.
struct BallLevels {
    template <class V>
    struct Rays {
        BesideAxis<V> beside;
        V shrink2;  // 1 / (1 + u1^2 + v1^2)
    };
    template <class V>
    struct Cell {
        V x, y, z, radius, inverse, from_start;
    };

    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE Rays<V> rays(D d, const Path& /*path*/, const HitLanes& t, int lane) {
        const BesideAxis<V> beside = rays_beside(d, t, lane);
        const V one = hn::Set(d, hn::TFromD<D>(1));
        const V side2 = hn::Add(hn::Mul(beside.u1, beside.u1), hn::Mul(beside.v1, beside.v1));
        return {beside, hn::Div(one, hn::Add(one, side2))};
    }
    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE Cell<V> shared(D d, const hn::TFromD<D>* row) {
        return {hn::Set(d, row[0]), hn::Set(d, row[1]), hn::Set(d, row[2]),
                hn::Set(d, row[3]), hn::Set(d, row[4]), hn::Set(d, row[Path::from_start])};
    }
    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE Cell<V> own(D d, const Cell<V>& start, const HitLanes& t, int k, int lane) {
        const auto row = [&](int i) HWY_ATTR { return hn::LoadU(d, t.map[k][i] + lane); };
        const V z = row(2), radius = row(3);
        return {hn::Add(start.x, row(0)),
                hn::Add(start.y, row(1)),
                hn::Add(start.z, z),
                radius,
                hn::Div(hn::Set(d, 1.0F), radius),
                z};
    }
    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE LevelHits<V> meet(D d, const Cell<V>& cell, const Rays<V>& ray,
                                        PathSide side) {
        const auto& [u0, u1, v0, v1] = ray.beside;
        const V one = hn::Set(d, hn::TFromD<D>(1));
        const V x = hn::Mul(hn::Sub(cell.x, hn::Add(u0, hn::Mul(u1, cell.z))), cell.inverse);
        const V y = hn::Mul(hn::Sub(cell.y, hn::Add(v0, hn::Mul(v1, cell.z))), cell.inverse);
        const Slant<V> slant{u1, v1, ray.shrink2};
        const BallPass<V> pass(x, y, one, slant);
        const V half = pass.half(slant);
        const V key = hn::Sub(pass.ahead, half), exit = hn::Add(pass.ahead, half);
        const V at = side == PathSide::entry ? key : exit;
        return {hn::Add(cell.from_start, hn::Mul(key, cell.radius)),
                hn::Add(cell.from_start, hn::Mul(exit, cell.radius)),
                {hn::Sub(hn::Mul(u1, at), x), hn::Sub(hn::Mul(v1, at), y), at}};
    }
};

/// Boxes, in the object's unit coordinates from the entry cell's centre.
struct BoxLevels {
    template <class V>
    struct Rays {
        Lanes3<V> origin;      // where they pass the entry cell's base
        Lanes3<V> pace;        // depth per unit of each axis
        Lanes3<V> half;        // its size
        Lanes3<V> slow;        // half, along axes that the rays hardly move along; else 0
        bool parallel;         // to some faces
        Lanes3<V> normals[3];  // of the faces where they enter, in the packet's frame
    };
    template <class V>
    struct Cell {
        Lanes3<V> center;
        V size;
    };

    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE Rays<V> rays(D d, const Path& path, const HitLanes& t, int lane) {
        using T = hn::TFromD<D>;
        const BesideAxis<V> beside = rays_beside(d, t, lane);
        const V base = hn::Set(d, static_cast<T>(path.start_base));
        const V u = hn::Add(beside.u0, hn::Mul(beside.u1, base));
        const V v = hn::Add(beside.v0, hn::Mul(beside.v1, base));
        const auto along = [&](std::size_t k, std::size_t axis) HWY_ATTR {
            return hn::Set(d, static_cast<T>(path.frame[3 * k + axis]));
        };
        Rays<V> rays;
        const auto axis = [&](std::size_t k, V& origin, V& pace, V& half) HWY_ATTR {
            const V speed = hn::Add(hn::Add(along(2, k), hn::Mul(beside.u1, along(0, k))),
                                    hn::Mul(beside.v1, along(1, k)));
            origin =
                hn::Add(hn::Add(along(3, k), hn::Mul(u, along(0, k))), hn::Mul(v, along(1, k)));
            const V still = hn::Set(d, T(1e-30));
            pace =
                hn::Div(hn::Set(d, T(1)), hn::IfThenElse(hn::Eq(speed, hn::Zero(d)), still, speed));
            half = hn::Abs(pace);
            const V sign = hn::CopySign(hn::Set(d, T(1)), hn::Neg(pace));
            const auto part = [&](int i) HWY_ATTR {
                return hn::Mul(sign, hn::Set(d, static_cast<T>(path.face[k][i])));
            };
            rays.normals[k] = {part(0), part(1), part(2)};
        };
        axis(0, rays.origin.x, rays.pace.x, rays.half.x);
        axis(1, rays.origin.y, rays.pace.y, rays.half.y);
        axis(2, rays.origin.z, rays.pace.z, rays.half.z);
        const V fastest = hn::Min(hn::Min(rays.half.x, rays.half.y), rays.half.z);
        const V slowest = hn::Mul(fastest, hn::Set(d, static_cast<T>(1 / slowest_share)));
        const auto slow = [&](V half)
                              HWY_ATTR { return hn::IfThenElseZero(hn::Lt(slowest, half), half); };
        rays.slow = {slow(rays.half.x), slow(rays.half.y), slow(rays.half.z)};
        const V any = max3(rays.slow.x, rays.slow.y, rays.slow.z);
        rays.parallel = !hn::AllFalse(d, hn::Lt(hn::Zero(d), any));
        return rays;
    }
    /// Rays so near to a face that they hardly leave it while they pass.
    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE auto in_face(D d, const Cell<V>& cell, const Rays<V>& ray) {
        using T = hn::TFromD<D>;
        const V fastest = hn::Min(hn::Min(ray.half.x, ray.half.y), ray.half.z);
        const auto axis = [&](V center, V origin, V slow) HWY_ATTR {
            const V aside = hn::Abs(hn::Sub(hn::Abs(hn::Sub(center, origin)), cell.size));
            const V drift = hn::Mul(cell.size, hn::Add(fastest, fastest));
            const V room = hn::Mul(cell.size, hn::Set(d, static_cast<T>(face_room)));
            return hn::And(hn::Lt(hn::Zero(d), slow),
                           hn::Le(hn::Mul(hn::Sub(aside, room), slow), drift));
        };
        return hn::Or(hn::Or(axis(cell.center.x, ray.origin.x, ray.slow.x),
                             axis(cell.center.y, ray.origin.y, ray.slow.y)),
                      axis(cell.center.z, ray.origin.z, ray.slow.z));
    }
    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE Cell<V> shared(D d, const hn::TFromD<D>* row) {
        return {broadcast(d, row), hn::Set(d, row[3])};
    }
    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE Cell<V> own(D d, const Cell<V>& /*start*/, const HitLanes& t, int k,
                                  int lane) {
        const auto row = [&](int i) HWY_ATTR { return hn::LoadU(d, t.map[k][i] + lane); };
        return {{row(0), row(1), row(2)}, row(3)};
    }
    template <class D, class V = hn::VFromD<D>>
    static HWY_INLINE LevelHits<V> meet(D d, const Cell<V>& cell, const Rays<V>& ray,
                                        PathSide side) {
        const auto slab = [&](V center, V origin, V pace, V half) HWY_ATTR {
            const V middle = hn::Mul(hn::Sub(center, origin), pace);
            const V wide = hn::Mul(cell.size, half);
            return LaneInterval<V>{hn::Sub(middle, wide), hn::Add(middle, wide)};
        };
        const auto x = slab(cell.center.x, ray.origin.x, ray.pace.x, ray.half.x);
        const auto y = slab(cell.center.y, ray.origin.y, ray.pace.y, ray.half.y);
        const auto z = slab(cell.center.z, ray.origin.z, ray.pace.z, ray.half.z);
        V key = max3(x.key, y.key, z.key);
        const V exit = hn::Min(hn::Min(x.exit, y.exit), z.exit);
        if (ray.parallel) key = hn::IfThenElse(in_face(d, cell, ray), hn::NaN(d), key);
        const bool enters = side == PathSide::entry;
        const auto is_x = enters ? hn::Eq(x.key, key) : hn::Eq(x.exit, exit);
        const auto is_y = enters ? hn::Eq(y.key, key) : hn::Eq(y.exit, exit);
        const auto face = [&](V nx, V ny, V nz) HWY_ATTR {
            const V normal = hn::IfThenElse(is_x, nx, hn::IfThenElse(is_y, ny, nz));
            return enters ? normal : hn::Neg(normal);
        };
        (void)d;
        return {key,
                exit,
                {face(ray.normals[0].x, ray.normals[1].x, ray.normals[2].x),
                 face(ray.normals[0].y, ray.normals[1].y, ray.normals[2].y),
                 face(ray.normals[0].z, ray.normals[1].z, ray.normals[2].z)}};
    }
};

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
