// The cells on the way from an object to a hit, a level in each lane: what shading (Ch. 17) adds
// up. The levels of a start cell are made once and serve all rays that hit below it.
#if defined(PXM_HOST_WIDE_PATH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_PATH_INL
#undef PXM_HOST_WIDE_PATH_INL
#else
#define PXM_HOST_WIDE_PATH_INL
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "host/wide/bundle_search.hpp"
#include "host/wide/fixed_levels.inl"
#include "host/wide/lanes.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// FNV-1a over a symbol, as in host/render/gather.hpp.
inline std::uint32_t hash_symbol(std::uint32_t hash, int symbol) {
    constexpr std::uint32_t prime = 0x0100'0193;
    for (auto rest = static_cast<std::uint32_t>(symbol) + 1; rest != 0; rest >>= 8) {
        hash = (hash ^ (rest & 0xFF)) * prime;
    }
    return (hash ^ 0xFF) * prime;
}

/// As gather.hpp keeps it in an image: 24 bits, never 0.
inline std::uint32_t folded(std::uint32_t hash) {
    const std::uint32_t short_hash = (hash >> 24 ^ hash) & 0x00FF'FFFF;
    return short_hash == 0 ? 1 : short_hash;
}

inline void blend(std::array<float, 3>& color, const std::array<float, 4>& paint) {
    const float a = paint[3];
    for (std::size_t i = 0; i < 3; ++i) color[i] = (1 - a) * color[i] + a * paint[i];
}

inline std::size_t child_lane(const WideSet& set, int symbol) {
    const auto found = std::ranges::lower_bound(set.maps, symbol);
    return static_cast<std::size_t>(found - set.maps.begin());
}

/// A path to fill in, for a start cell at that level.
inline Path& new_path(const WideScene& scene, Workspace& work, int object, std::uint32_t level,
                      int& index) {
    if (work.paths.size() == work.paths_used) work.paths.push_back(Path{});
    index = static_cast<int>(work.paths_used++);
    Path& path = work.paths[static_cast<std::size_t>(index)];
    path.shared = static_cast<int>(level) + 1;
    path.object = object;
    path.color = scene.objects[static_cast<std::size_t>(object)].color;
    path.hash = scene.objects[static_cast<std::size_t>(object)].hash;
    return path;
}

/// A start cell that is smaller than this share of its object: a float cannot tell well enough
/// where rays enter the largest cells on its path.
inline constexpr double deep_share = 0x1p-10;

inline void put_level(Path& path, int level, const std::array<double, 12>& rows, double base,
                      double diameter) {
    for (std::size_t i = 0; i < 12; ++i) {
        path.rows[Path::map + i][level] = static_cast<float>(rows[i]);
    }
    path.rows[Path::base][level] = static_cast<float>(base);
    path.rows[Path::from_start][level] = static_cast<float>(base - path.start_base);
    path.rows[Path::diameter][level] = static_cast<float>(diameter);
    if (level == 0) path.deep = diameter * deep_share > path.start_diameter;
    for (std::size_t i = 0; i < 12; ++i) path.twice[Path::map + i][level] = rows[i];
    path.twice[Path::base][level] = base;
}

/// The path of a start cell, its shared levels filled in. Null if it is too long.
inline Path* path_of(const WideScene& scene, Workspace& work, int start) {
    SharedCell& cell = work.cells[static_cast<std::size_t>(start)];
    if (cell.level + 1 > Path::capacity) return nullptr;
    if (cell.path >= 0) return &work.paths[static_cast<std::size_t>(cell.path)];
    Path& path = new_path(scene, work, cell.object, cell.level, cell.path);
    path.start_base = cell.base;
    path.start_diameter = cell.diameter;
    int cells[Path::capacity];
    int at = start;
    for (int level = path.shared - 1; level >= 0; --level) {
        cells[level] = at;
        at = work.cells[static_cast<std::size_t>(at)].parent;
    }
    for (int level = 0; level < path.shared; ++level) {
        const SharedCell& inner = work.cells[static_cast<std::size_t>(cells[level])];
        put_level(path, level, inner.rows, inner.base, inner.diameter);
        if (level == 0) continue;
        path.hash = hash_symbol(path.hash, inner.symbol);
        if (!scene.objects[static_cast<std::size_t>(cell.object)].colored) continue;
        const SharedCell& parent = work.cells[static_cast<std::size_t>(inner.parent)];
        const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
        blend(path.color, set.colors[child_lane(set, inner.symbol)]);
    }
    return &path;
}

/// The same for homotheties.
inline Path* path_of_fixed(const WideScene& scene, Workspace& work, int start) {
    FixedCell& cell = work.fixed_cells[static_cast<std::size_t>(start)];
    if (cell.level + 1 > Path::capacity) return nullptr;
    if (cell.path >= 0) return &work.paths[static_cast<std::size_t>(cell.path)];
    Path& path = new_path(scene, work, cell.object, cell.level, cell.path);
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    std::array<double, 12> rows;
    rows_of(object, work.bundle, cell, rows, path.start_base);
    path.start_diameter = cell.diameter;
    int cells[Path::capacity];
    int at = start;
    for (int level = path.shared - 1; level >= 0; --level) {
        cells[level] = at;
        at = work.fixed_cells[static_cast<std::size_t>(at)].parent;
    }
    for (int level = 0; level < path.shared; ++level) {
        const FixedCell& inner = work.fixed_cells[static_cast<std::size_t>(cells[level])];
        double base = 0;
        rows_of(object, work.bundle, inner, rows, base);
        put_level(path, level, rows, base, inner.diameter);
        if (level == 0) continue;
        const FixedCell& parent = work.fixed_cells[static_cast<std::size_t>(inner.parent)];
        const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
        const auto lane = static_cast<std::size_t>(inner.lane);
        path.hash = hash_symbol(path.hash, set.maps[lane]);
        if (object.colored) blend(path.color, set.colors[lane]);
    }
    return &path;
}

/// Adds the levels of a single ray to a path of homotheties: a cell is its centre and size.
inline int add_own_homotheties(const WideScene& scene, const Workspace& work, const Found& found,
                               Path& path, std::uint32_t& hash, std::array<float, 3>& color) {
    if (path.shared + found.below_count > Path::capacity) return 0;
    const FixedCell& cell = work.fixed_cells[static_cast<std::size_t>(found.start)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    const int start = path.shared - 1;
    float center[3] = {0, 0, 0};
    float size = 1;
    auto constant = static_cast<float>(cell.constant);
    int set_index = cell.set;
    for (int k = 0; k < found.below_count; ++k) {
        const WideSet& set = scene.sets[static_cast<std::size_t>(set_index)];
        const std::size_t lane = found.below[static_cast<std::size_t>(k)];
        const HomothetyTable& table = set.children;
        const int level = path.shared + k;
        for (int axis = 0; axis < 3; ++axis) center[axis] += size * table.rows.row(axis)[lane];
        size *= table.rows.row(HomothetyTable::scale)[lane];
        const float inverse = 1 / size;
        for (int i = 0; i < 9; ++i) path.rows[i][level] = path.rows[i][start] * inverse;
        for (int axis = 0; axis < 3; ++axis) {
            path.rows[9 + axis][level] = (path.rows[9 + axis][start] - center[axis]) * inverse;
        }
        path.rows[Path::base][level] = path.rows[Path::base][start];
        path.rows[Path::from_start][level] = 0;
        path.rows[Path::diameter][level] =
            constant * table.rows.row(HomothetyTable::diameter)[lane];
        constant *= table.rows.row(HomothetyTable::constant)[lane];
        hash = hash_symbol(hash, set.maps[lane]);
        if (object.colored) blend(color, set.colors[lane]);
        set_index = set.sets[lane];
    }
    return path.shared + found.below_count;
}

/// Adds the levels of a single ray to a path. Returns the number of levels, or 0 if too many.
inline int add_own_levels(const WideScene& scene, const Workspace& work, const Found& found,
                          Path& path, std::uint32_t& hash, std::array<float, 3>& color) {
    const hn::ScalableTag<float> d;
    using V = hn::VFromD<decltype(d)>;
    hash = path.hash;
    color = path.color;
    if (found.below_count >= 0) {
        return add_own_homotheties(scene, work, found, path, hash, color);
    }
    if (found.block < 0) return path.shared;
    const Block* blocks = work.blocks.data();
    const int own = static_cast<int>(blocks[found.block].level) + 1 - path.shared;
    const int levels = path.shared + own;
    if (levels > Path::capacity - table_step) return 0;
    alignas(64) float maps[12][Path::capacity];
    std::array<int, Path::capacity> sets, lanes;
    int lane = found.lane;
    for (int k = own - 1, index = found.block; k >= 0; --k) {
        const Block& block = blocks[index];
        const WideSet& set = scene.sets[static_cast<std::size_t>(block.set)];
        for (int i = 0; i < 12; ++i) maps[i][k] = block.rows[i * set.stride + lane];
        path.rows[Path::diameter][path.shared + k] =
            block.rows[Block::diameter * set.stride + lane];
        sets[static_cast<std::size_t>(k)] = block.set;
        lanes[static_cast<std::size_t>(k)] = lane;
        lane = block.lane;
        index = block.parent;
    }
    const int start = path.shared - 1;
    const auto outer = [&](int row) HWY_ATTR {
        return Lanes3<V>{hn::Set(d, path.rows[3 * row][start]),
                         hn::Set(d, path.rows[3 * row + 1][start]),
                         hn::Set(d, path.rows[3 * row + 2][start])};
    };
    const Lanes3<V> u = outer(0), v = outer(1), w = outer(2), o = outer(3);
    const V base = hn::Set(d, path.rows[Path::base][start]);
    for (int i = 0; i < own; i += static_cast<int>(hn::Lanes(d))) {
        const Lanes3x3<V> map = load3x3(d, maps[0] + i, Path::capacity);
        const int at = path.shared + i;
        store3(transform(u, map), d, path.rows[0] + at, Path::capacity);
        store3(transform(v, map), d, path.rows[3] + at, Path::capacity);
        store3(transform(w, map), d, path.rows[6] + at, Path::capacity);
        store3(add(transform(o, map), load3(d, maps[9] + i, Path::capacity)), d, path.rows[9] + at,
               Path::capacity);
        hn::StoreU(base, d, path.rows[Path::base] + at);
        hn::StoreU(hn::Zero(d), d, path.rows[Path::from_start] + at);
    }
    const WideObject& object = scene.objects[static_cast<std::size_t>(
        work.cells[static_cast<std::size_t>(found.start)].object)];
    for (std::size_t k = 0; k < static_cast<std::size_t>(own); ++k) {
        const WideSet& set = scene.sets[static_cast<std::size_t>(sets[k])];
        const auto child = static_cast<std::size_t>(lanes[k]);
        hash = hash_symbol(hash, set.maps[child]);
        if (object.colored) blend(color, set.colors[child]);
    }
    return levels;
}

/// What a ray finds at each level of a path: depths from the start cell's base, and the unit normal
/// where it enters the volume (or leaves it), in the bundle's frame.
struct PathHits {
    static constexpr int room = Path::capacity + table_step;  // whole registers are stored
    alignas(64) float key[room];
    alignas(64) float exit[room];
    alignas(64) float normal[3][room];
};

enum class PathSide { entry, exit };

template <class D, class V = hn::VFromD<D>>
HWY_INLINE void put_hits(D d, V v, float* to) {
    if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
        hn::StoreU(v, d, to);
    } else {
        const hn::Rebind<float, D> narrow;
        hn::StoreU(hn::DemoteTo(narrow, v), narrow, to);
    }
}

/// Cells of a path, or one cell of several paths: as Path has them, in lanes.
template <class V>
struct LevelRows {
    Lanes3<V> u, v, w, o;
    V base, from_start;
};

/// A ray beside the bundle's axis, or several.
template <class V>
struct BesideAxis {
    V u0, u1, v0, v1;
};

template <class V>
struct LevelHits {
    V key, exit;
    Lanes3<V> normal;
};

/// Where rays are in cells; the normals are those where they enter (leave) them.
template <class D, class V = hn::VFromD<D>>
HWY_INLINE LevelHits<V> meet_levels(D d, const LevelRows<V>& cell, const BesideAxis<V>& ray,
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

/// The levels [first, last) of a path; `rows` as in Path, of floats or doubles.
template <class T>
inline void hit_levels(const RayBundle& bundle, const Path& path, const T* rows, int first,
                       int last, int ray, bool spheres, PathSide side, PathHits& hits) {
    const hn::ScalableTag<T> d;
    using V = hn::VFromD<decltype(d)>;
    constexpr int stride = Path::capacity;
    const BesideAxis<V> beside{hn::Set(d, bundle.u0[ray]), hn::Set(d, bundle.u1[ray]),
                               hn::Set(d, bundle.v0[ray]), hn::Set(d, bundle.v1[ray])};
    const int lanes = static_cast<int>(hn::Lanes(d));
    for (int i = first; i < last; i += lanes) {
        const auto row = [&](int k) HWY_ATTR { return load3(d, rows + k * stride + i, stride); };
        const V base = hn::LoadU(d, rows + Path::base * stride + i);
        V from_start = hn::Sub(base, hn::Set(d, static_cast<T>(path.start_base)));
        if constexpr (sizeof(T) == sizeof(float)) {  // from the difference in double
            from_start = hn::LoadU(d, rows + Path::from_start * stride + i);
        }
        const LevelHits<V> met = meet_levels(
            d, LevelRows<V>{row(0), row(3), row(6), row(9), base, from_start}, beside, spheres,
            side);
        put_hits(d, met.key, hits.key + i);
        put_hits(d, met.exit, hits.exit + i);
        put_hits(d, met.normal.x, hits.normal[0] + i);
        put_hits(d, met.normal.y, hits.normal[1] + i);
        put_hits(d, met.normal.z, hits.normal[2] + i);
    }
}

inline void hit_path(const RayBundle& bundle, const Path& path, int levels, int ray, bool spheres,
                     PathSide side, PathHits& hits) {
    int first = 0;
    if (path.deep) {
        hit_levels(bundle, path, path.twice[0], 0, path.shared, ray, spheres, side, hits);
        first = path.shared;
    }
    hit_levels(bundle, path, path.rows[0], first, levels, ray, spheres, side, hits);
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
