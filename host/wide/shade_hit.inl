// Shading of a hit (Ch. 17): the cells on the way from the object to it are the lanes. The same
// walk checks what the search skipped: that the ray meets every cell of the path within its
// parent's interval, and that none but the last is terminal. As in dsp_kernels/shade.hpp.
#if defined(PXM_HOST_WIDE_SHADE_HIT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SHADE_HIT_INL
#undef PXM_HOST_WIDE_SHADE_HIT_INL
#else
#define PXM_HOST_WIDE_SHADE_HIT_INL
#endif

#include <hwy/highway.h>

#include <cmath>

#include "host/wide/fixed_levels.inl"
#include "host/wide/lanes.inl"
#include "host/wide/tile_search.hpp"

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
    path.hash = 0x811C'9DC5;
    return path;
}

inline void put_level(Path& path, int level, const std::array<double, 12>& rows, double base,
                      double diameter) {
    for (std::size_t i = 0; i < 12; ++i) {
        path.rows[Path::map + i][level] = static_cast<float>(rows[i]);
    }
    path.rows[Path::base][level] = static_cast<float>(base);
    path.rows[Path::from_start][level] = static_cast<float>(base - path.start_base);
    path.rows[Path::diameter][level] = static_cast<float>(diameter);
}

/// The path of a start cell, its shared levels filled in. Null if it is too long.
inline Path* path_of(const WideScene& scene, Workspace& work, int start) {
    SharedCell& cell = work.cells[static_cast<std::size_t>(start)];
    if (cell.level + 1 > Path::capacity) return nullptr;
    if (cell.path >= 0) return &work.paths[static_cast<std::size_t>(cell.path)];
    Path& path = new_path(scene, work, cell.object, cell.level, cell.path);
    path.start_base = cell.base;
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
    rows_of(object, work.tile, cell, rows, path.start_base);
    int cells[Path::capacity];
    int at = start;
    for (int level = path.shared - 1; level >= 0; --level) {
        cells[level] = at;
        at = work.fixed_cells[static_cast<std::size_t>(at)].parent;
    }
    for (int level = 0; level < path.shared; ++level) {
        const FixedCell& inner = work.fixed_cells[static_cast<std::size_t>(cells[level])];
        double base = 0;
        rows_of(object, work.tile, inner, rows, base);
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
/// where it enters the volume (leaves it, at `exit_level`), in the tile's frame.
struct PathHits {
    alignas(64) float key[Path::capacity];
    alignas(64) float exit[Path::capacity];
    alignas(64) float normal[3][Path::capacity];
};

enum class PathSide { entry, exit };

inline void hit_path(const Workspace& work, const Path& path, int levels, int ray, bool spheres,
                     PathSide side, PathHits& hits) {
    const hn::ScalableTag<float> d;
    using V = hn::VFromD<decltype(d)>;
    const TileView& tile = work.tile;
    const V u0 = hn::Set(d, tile.u0[ray]), u1 = hn::Set(d, tile.u1[ray]);
    const V v0 = hn::Set(d, tile.v0[ray]), v1 = hn::Set(d, tile.v1[ray]);
    for (int i = 0; i < levels; i += static_cast<int>(hn::Lanes(d))) {
        const float* rows = path.rows[0] + i;
        const Lanes3<V> u = load3(d, rows, Path::capacity);
        const Lanes3<V> v = load3(d, rows + 3 * Path::capacity, Path::capacity);
        const Lanes3<V> w = load3(d, rows + 6 * Path::capacity, Path::capacity);
        const Lanes3<V> o = load3(d, rows + 9 * Path::capacity, Path::capacity);
        const V base = hn::LoadU(d, rows + Path::base * Path::capacity);
        const V from_start = hn::LoadU(d, rows + Path::from_start * Path::capacity);
        const Lanes3<V> origin = add_scaled(add_scaled(o, hn::Add(u0, hn::Mul(u1, base)), u),
                                            hn::Add(v0, hn::Mul(v1, base)), v);
        const Lanes3<V> direction = add_scaled(add_scaled(w, u1, u), v1, v);
        Lanes3<V> normal;  // in unit coordinates
        LaneInterval<V> inside;
        if (spheres) {
            inside = in_unit_ball(d, origin, direction);
            normal =
                add_scaled(origin, side == PathSide::entry ? inside.key : inside.exit, direction);
        } else {
            inside = in_unit_cube(d, origin, direction);
            normal = cube_normal(d, origin, direction,
                                 side == PathSide::entry ? inside.key : inside.exit);
        }
        const Lanes3<V> seen{dot(normal, u), dot(normal, v), dot(normal, w)};
        const V length = hn::Sqrt(dot(seen, seen));
        const V scale = hn::Div(hn::Set(d, 1.0F), hn::Max(length, hn::Set(d, 1e-30F)));
        hn::StoreU(hn::Add(from_start, inside.key), d, hits.key + i);
        hn::StoreU(hn::Add(from_start, inside.exit), d, hits.exit + i);
        store3(Lanes3<V>{hn::Mul(seen.x, scale), hn::Mul(seen.y, scale), hn::Mul(seen.z, scale)}, d,
               hits.normal[0] + i, Path::capacity);
    }
}

/// The weighted sum of the normals along a path (Eq. 17.3); both sums, for weights may all vanish.
class NormalSum {
  public:
    NormalSum(kernels::ShadingMode mode, float outermost) : mode_(mode), outermost_(outermost) {}
    void add(const PathHits& hits, int level, float diameter) {
        float weight = 1;                                                              // Eq. 17.4
        if (mode_ == kernels::ShadingMode::low_pass) weight = diameter;                // Eq. 17.5
        if (mode_ == kernels::ShadingMode::high_pass) weight = outermost_ - diameter;  // Eq. 17.6
        for (std::size_t i = 0; i < 3; ++i) {
            weighted_[i] += weight * hits.normal[i][level];
            plain_[i] += hits.normal[i][level];
        }
        total_ += weight;
    }
    [[nodiscard]] bool empty() const {
        return !(plain_[0] * plain_[0] + plain_[1] * plain_[1] + plain_[2] * plain_[2] > 0);
    }
    [[nodiscard]] std::array<float, 3> unit() const {
        std::array<float, 3> n = total_ > 0 ? weighted_ : plain_;  // Erratum 18
        const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (float& x : n) x /= length;
        return n;
    }

  private:
    kernels::ShadingMode mode_;
    float outermost_;
    std::array<float, 3> weighted_{};
    std::array<float, 3> plain_{};
    float total_ = 0;
};

/// Lambert's law (Eq. 17.1) at a point.
inline std::array<float, 3> lit(const WideScene& scene, const std::array<float, 3>& normal,
                                const std::array<float, 3>& point, float diffuse,
                                const std::array<float, 3>& color) {
    std::array<float, 3> sum = scene.ambient;
    for (const CompiledLight& light : scene.lights) {
        glm::vec3 toward{light.place};
        if (light.kind == kernels::LightKind::point) {
            toward -= glm::vec3{point[0], point[1], point[2]};
            toward /= std::sqrt(toward.x * toward.x + toward.y * toward.y + toward.z * toward.z);
        }
        const float facing = normal[0] * toward.x + normal[1] * toward.y + normal[2] * toward.z;
        if (!(facing > 0)) continue;
        for (int i = 0; i < 3; ++i) {
            sum[static_cast<std::size_t>(i)] +=
                diffuse * facing * static_cast<float>(light.color[i]);
        }
    }
    return {sum[0] * color[0], sum[1] * color[1], sum[2] * color[2]};
}

/// Walks the path: false unless the ray meets every cell, and the last one alone is terminal.
inline bool confirm(const WideScene& scene, const Workspace& work, const Path& path, int levels,
                    int ray, const PathHits& hits, float& depth) {
    const WideObject& object = scene.objects[static_cast<std::size_t>(path.object)];
    const double growth = scene.camera.pixel_growth * static_cast<double>(work.tile.stretch[ray]);
    const auto p0 =
        static_cast<float>(scene.detail * (scene.camera.pixel_at_eye + growth * path.start_base));
    const auto p1 = static_cast<float>(scene.detail * growth);
    const auto least = static_cast<float>(scene.detail * object.smallest_pixel);
    float key = static_cast<float>(-path.start_base);
    float exit = std::numeric_limits<float>::infinity();
    for (int level = 0; level < levels; ++level) {
        if (!(hits.key[level] <= hits.exit[level])) return false;  // NaN as well
        key = std::max(key, hits.key[level]);
        exit = std::min(exit, hits.exit[level]);
        if (exit < key) return false;
        const bool terminal = static_cast<std::uint32_t>(level) == object.levels ||
                              path.rows[Path::diameter][level] <= std::max(p0 + p1 * key, least);
        if (terminal != (level == levels - 1)) return false;
    }
    depth = key;
    return true;
}

inline bool shade(const WideScene& scene, Workspace& work, int ray, Shaded& shaded) {
    const Found& found = work.found[static_cast<std::size_t>(ray)];
    Path* path = found.below_count >= 0 ? path_of_fixed(scene, work, found.start)
                                        : path_of(scene, work, found.start);
    if (path == nullptr) return false;
    const WideObject& object = scene.objects[static_cast<std::size_t>(path->object)];
    std::uint32_t hash = 0;
    std::array<float, 3> color;
    const int levels = add_own_levels(scene, work, found, *path, hash, color);
    if (levels == 0) return false;
    PathHits hits;
    hit_path(work, *path, levels, ray, object.spheres, PathSide::entry, hits);
    float depth = 0;
    if (!confirm(scene, work, *path, levels, ray, hits, depth)) return false;
    const float* diameters = path->rows[Path::diameter];
    NormalSum total(scene.shading, diameters[0]);
    const auto eye = static_cast<float>(-path->start_base);
    const bool facet = scene.shading == kernels::ShadingMode::facet;
    for (int level = facet ? levels - 1 : 0; level < levels; ++level) {
        if (eye < hits.key[level]) total.add(hits, level, diameters[level]);
    }
    if (total.empty()) {
        hit_path(work, *path, levels, ray, object.spheres, PathSide::exit, hits);
        total.add(hits, levels - 1, diameters[levels - 1]);
    }
    const std::array<float, 3> local = total.unit();
    const double z = path->start_base + static_cast<double>(depth);
    const TileView& tile = work.tile;
    const std::array<double, 3> place{
        static_cast<double>(tile.u0[ray]) + static_cast<double>(tile.u1[ray]) * z,
        static_cast<double>(tile.v0[ray]) + static_cast<double>(tile.v1[ray]) * z, z};
    std::array<float, 3> point;
    for (int i = 0; i < 3; ++i) {
        double n = 0;
        double q = 0;
        for (int k = 0; k < 3; ++k) {
            n += static_cast<double>(local[static_cast<std::size_t>(k)]) * tile.axis[k][i];
            q += place[static_cast<std::size_t>(k)] * tile.axis[k][i];
        }
        shaded.normal[static_cast<std::size_t>(i)] = static_cast<float>(n);
        point[static_cast<std::size_t>(i)] = static_cast<float>(q);
    }
    shaded.color = lit(scene, shaded.normal, point, object.diffuse, color);
    shaded.t = static_cast<float>(z * static_cast<double>(tile.stretch[ray]));
    shaded.object = path->object;
    shaded.level = levels - 1;
    const std::uint32_t folded = (hash >> 24 ^ hash) & 0x00FF'FFFF;
    shaded.word = folded == 0 ? 1 : folded;
    return true;
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
