// What a beam sees of a cell (Ch. 17): the levels of its path in lanes, in double. As
// dsp_kernels/shade.hpp and lights.hpp; a ray through the middle of a cell's places may miss the
// cells around it.
#if defined(PXM_HOST_WIDE_AREA_AREA_SHADE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_AREA_AREA_SHADE_INL
#undef PXM_HOST_WIDE_AREA_AREA_SHADE_INL
#else
#define PXM_HOST_WIDE_AREA_AREA_SHADE_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "host/wide/area/area_search.hpp"
#include "host/wide/shade/normal_sum.inl"
#include "host/wide/shade/path_levels.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline glm::dmat3 axes_of(const WideScene& scene, const BeamWorkspace& work, const BeamCell& cell) {
    if (cell.axes < 0) {
        const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
        return object.from_unit.linear * cell.size;
    }
    const double* own = work.axes[static_cast<std::size_t>(cell.axes)].data();
    return {own[0], own[1], own[2], own[3], own[4], own[5], own[6], own[7], own[8]};
}

inline void put_sight_level(const WideScene& scene, BeamWorkspace& work, int level, int index) {
    SightPath& path = work.path;
    const auto at = static_cast<std::size_t>(level);
    const BeamCell& cell = work.cells[static_cast<std::size_t>(index)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    path.cells[at] = index;
    path.diameters[at] = static_cast<float>(cell.diameter);
    const glm::dmat3 inverse = cell.axes < 0 ? object.to_unit.linear * (1 / cell.size)
                                             : glm::inverse(axes_of(scene, work, cell));
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            path.rows[SightPath::inverse + 3 * i + j][level] = inverse[i][j];
        }
        path.rows[SightPath::center + i][level] = cell.center[i];
    }
    path.spheres = object.spheres;
    path.colors[at] = level == 0 ? object.color : path.colors[at - 1];
    if (level == 0 || !object.colored) return;
    const BeamCell& parent = work.cells[static_cast<std::size_t>(cell.parent)];
    const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
    blend(path.colors[at], set.colors[static_cast<std::size_t>(cell.lane)]);
}

/// Fills in the levels down to a cell; those that are there already stay.
inline void put_sight_path(const WideScene& scene, BeamWorkspace& work, int cell) {
    SightPath& path = work.path;
    std::array<int, static_cast<std::size_t>(SightPath::capacity)> changed;
    const int last = static_cast<int>(work.cells[static_cast<std::size_t>(cell)].level);
    int level = last;
    for (int at = cell; level >= 0; --level) {
        const auto i = static_cast<std::size_t>(level);
        if (level < path.levels && path.cells[i] == at) break;
        changed[i] = at;
        at = work.cells[static_cast<std::size_t>(at)].parent;
    }
    while (++level <= last) {
        put_sight_level(scene, work, level, changed[static_cast<std::size_t>(level)]);
    }
    path.levels = last + 1;
}

/// Where a ray enters (or leaves) the volumes of a path, along its length, and the normals there.
struct SightHits {
    static constexpr int room = SightPath::capacity + table_step;
    alignas(64) double key[room];
    alignas(64) double exit[room];
    alignas(64) double normal[3][room];
};

inline void hit_sight_levels(const SightPath& path, const LoneRay& ray, double base, PathSide side,
                             SightHits& hits) {
    const hn::ScalableTag<double> d;
    const bool spheres = path.spheres;
    using V = hn::VFromD<decltype(d)>;
    constexpr int stride = SightPath::capacity + table_step;
    const glm::dvec3 from = ray.origin + base * ray.direction;
    const Lanes3<V> point = broadcast(d, &from.x), way = broadcast(d, &ray.direction.x);
    const V start = hn::Set(d, base);
    for (int i = 0; i < path.levels; i += static_cast<int>(hn::Lanes(d))) {
        const Lanes3x3<V> map = load3x3(d, path.rows[0] + i, stride);
        const Lanes3<V> center = load3(d, path.rows[SightPath::center] + i, stride);
        const Lanes3<V> o =
            transform(Lanes3<V>{hn::Sub(point.x, center.x), hn::Sub(point.y, center.y),
                                hn::Sub(point.z, center.z)},
                      map);
        const Lanes3<V> s = transform(way, map);
        const LaneInterval<V> inside = spheres ? in_unit_ball(d, o, s) : in_unit_cube(d, o, s);
        const V t = side == PathSide::entry ? inside.key : inside.exit;
        const Lanes3<V> out = spheres ? add_scaled(o, t, s) : cube_normal(d, o, s, t);
        const Lanes3<V> seen{dot(map.row[0], out), dot(map.row[1], out), dot(map.row[2], out)};
        const V length = hn::Sqrt(dot(seen, seen));
        const V scale = hn::Div(hn::Set(d, 1.0), hn::Max(length, hn::Set(d, 1e-200)));
        hn::StoreU(hn::Add(start, inside.key), d, hits.key + i);
        hn::StoreU(hn::Add(start, inside.exit), d, hits.exit + i);
        hn::StoreU(hn::Mul(seen.x, scale), d, hits.normal[0] + i);
        hn::StoreU(hn::Mul(seen.y, scale), d, hits.normal[1] + i);
        hn::StoreU(hn::Mul(seen.z, scale), d, hits.normal[2] + i);
    }
}

inline glm::vec3 normal_at(const SightHits& hits, int level) {
    return {static_cast<float>(hits.normal[0][level]), static_cast<float>(hits.normal[1][level]),
            static_cast<float>(hits.normal[2][level])};
}

/// The normals of the cells around an object that became objects of their own.
inline void give_enclosing(const WideScene& scene, BeamWorkspace& work, const WideObject& object,
                           const LoneRay& ray, const PathWeights& weights) {
    if (object.enclosing < 0) return;
    RayPacket packet;
    gather_rays(packet, std::span{&ray, 1});
    find_enclosing(scene, object, packet, 0, work.enclosing);
    for (const EnclosingNormal& cell : work.enclosing) {
        work.given.push_back(
            {to_scene(packet, cell.normal), cell.depth, weights.of(cell.diameter)});
    }
}

/// As walk_path() of dsp_kernels/shade.hpp.
inline void give_normals(const WideScene& scene, BeamWorkspace& work, const WideObject& object,
                         const LoneRay& ray, double key) {
    const SightPath& path = work.path;
    std::vector<GivenNormal>& given = work.given;
    const PathWeights weights{scene.shading, object.enclosing < 0
                                                 ? path.diameters[0]
                                                 : static_cast<float>(object.widest)};
    given.clear();
    give_enclosing(scene, work, object, ray, weights);
    SightHits hits;
    hit_sight_levels(path, ray, key, PathSide::entry, hits);
    const int last = path.levels - 1;
    const bool facet = scene.shading == kernels::ShadingMode::facet;
    for (int level = facet ? last : 0; level <= last; ++level) {
        if (!(ray.start < hits.key[level] && hits.key[level] <= hits.exit[level])) continue;
        given.push_back({normal_at(hits, level), hits.key[level],
                         weights.of(path.diameters[static_cast<std::size_t>(level)])});
    }
    if (!given.empty()) return;
    const float weight = weights.of(path.diameters[static_cast<std::size_t>(last)]);
    if (hits.key[last] <= hits.exit[last]) {
        hit_sight_levels(path, ray, key, PathSide::exit, hits);
        given.push_back({normal_at(hits, last), hits.exit[last], weight});
    } else {
        given.push_back({-glm::vec3{ray.direction}, key, weight});
    }
}

/// How much the cells of a path face a point light, on average (Eq. 17.3 in full).
inline float facing_lamp(const std::vector<GivenNormal>& given, const LoneRay& ray,
                         const glm::dvec3& lamp) {
    float weighted = 0, plain = 0, total = 0;
    for (const GivenNormal& cell : given) {
        const glm::vec3 toward{glm::normalize(lamp - ray.origin - cell.depth * ray.direction)};
        const float cosine = std::max(0.0F, glm::dot(cell.normal, toward));
        weighted += cell.weight * cosine;
        plain += cosine;
        total += cell.weight;
    }
    return total > 0 ? weighted / total : plain / static_cast<float>(given.size());
}

inline void see_along(const WideScene& scene, BeamWorkspace& work, int index, const LoneRay& ray,
                      ShadedHit& seen) {
    put_sight_path(scene, work, index);
    const BeamCell& cell = work.cells[static_cast<std::size_t>(index)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    give_normals(scene, work, object, ray, cell.key);
    const std::vector<GivenNormal>& given = work.given;
    PathWalk sum;
    for (const GivenNormal& one : given) sum.add(one.normal, one.weight);
    const glm::vec3 normal = sum.normal();
    seen.normal = {normal.x, normal.y, normal.z};
    seen.color = work.path.colors[static_cast<std::size_t>(cell.level)];
    seen.depth = cell.key;
    seen.object = cell.object;
    seen.level = static_cast<int>(cell.level);
    face_lights(scene, normal, seen,
                [&](const CompiledLight& lamp) { return facing_lamp(given, ray, lamp.place); });
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
