// Shading of a hit (Ch. 17), from the levels of its path. The same walk checks what the search
// skipped: that the ray meets every cell of the path within its parent's interval, and that none
// but the last is terminal. As in dsp_kernels/shade.hpp and lights.hpp.
#if defined(PXM_HOST_WIDE_SHADE_HIT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SHADE_HIT_INL
#undef PXM_HOST_WIDE_SHADE_HIT_INL
#else
#define PXM_HOST_WIDE_SHADE_HIT_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host/wide/path.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// How cells are weighted along a path (Eqs. 17.4 to 17.6).
struct PathWeights {
    kernels::ShadingMode mode;
    float outermost;  // diameter

    [[nodiscard]] float of(float diameter) const {
        if (mode == kernels::ShadingMode::low_pass) return diameter;               // Eq. 17.5
        if (mode == kernels::ShadingMode::high_pass) return outermost - diameter;  // Eq. 17.6
        return 1;                                                                  // Eq. 17.4
    }
};

/// The levels of a path that give a normal: those that the ray enters, or the last one alone.
struct Visited {
    std::array<int, Path::capacity> level;
    int count = 0;
    bool leaves = false;  // the last one, where the ray leaves it
};

inline Visited visited_levels(const Path& path, int levels, kernels::ShadingMode mode,
                              const PathHits& hits) {
    Visited visited;
    const auto eye = static_cast<float>(-path.start_base);
    const bool facet = mode == kernels::ShadingMode::facet;
    for (int level = facet ? levels - 1 : 0; level < levels; ++level) {
        if (!(eye < hits.key[level])) continue;
        visited.level[static_cast<std::size_t>(visited.count++)] = level;
    }
    visited.leaves = visited.count == 0;
    if (visited.leaves) visited.level[static_cast<std::size_t>(visited.count++)] = levels - 1;
    return visited;
}

/// The unit vector along the weighted sum of the normals (Eq. 17.3), in the tile's frame. When all
/// weights vanish, they are all 1 (Erratum 18).
inline glm::vec3 total_normal(const Path& path, const PathWeights& weights, const Visited& visited,
                              const PathHits& hits) {
    glm::vec3 weighted{0}, plain{0};
    float total = 0;
    for (int i = 0; i < visited.count; ++i) {
        const int level = visited.level[static_cast<std::size_t>(i)];
        const glm::vec3 normal{hits.normal[0][level], hits.normal[1][level], hits.normal[2][level]};
        const float weight = weights.of(path.rows[Path::diameter][level]);
        weighted += weight * normal;
        plain += normal;
        total += weight;
    }
    const glm::vec3 sum = total > 0 ? weighted : plain;
    return sum / std::sqrt(glm::dot(sum, sum));
}

/// How much a place faces a point light: the weighted mean over the cells of its path, each by
/// itself (Eq. 17.3 in full, as dsp_kernels/lights.hpp). `light` in the tile's frame.
inline float facing_point_light(const TileView& tile, const Path& path, const PathWeights& weights,
                                const Visited& visited, const PathHits& hits, int ray,
                                const glm::dvec3& light) {
    float weighted = 0;
    float plain = 0;
    float total = 0;
    for (int i = 0; i < visited.count; ++i) {
        const int level = visited.level[static_cast<std::size_t>(i)];
        const float depth = visited.leaves ? hits.exit[level] : hits.key[level];
        const double z = path.start_base + static_cast<double>(depth);
        const glm::dvec3 point{
            static_cast<double>(tile.u0[ray]) + static_cast<double>(tile.u1[ray]) * z,
            static_cast<double>(tile.v0[ray]) + static_cast<double>(tile.v1[ray]) * z, z};
        const glm::vec3 toward{glm::normalize(light - point)};
        const float cosine =
            std::max(0.0F, hits.normal[0][level] * toward.x + hits.normal[1][level] * toward.y +
                               hits.normal[2][level] * toward.z);
        const float weight = weights.of(path.rows[Path::diameter][level]);
        weighted += weight * cosine;
        plain += cosine;
        total += weight;
    }
    return total > 0 ? weighted / total : plain / static_cast<float>(visited.count);
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

/// The tile's frame to scene units.
inline glm::vec3 to_scene(const TileView& tile, const glm::vec3& v) {
    return glm::vec3{tile.axis[0]} * v.x + glm::vec3{tile.axis[1]} * v.y +
           glm::vec3{tile.axis[2]} * v.z;
}

inline glm::dvec3 to_tile(const TileView& tile, const glm::dvec3& v) {
    return {glm::dot(v, tile.axis[0]), glm::dot(v, tile.axis[1]), glm::dot(v, tile.axis[2])};
}

/// Whether a ray enters a shared cell so near the eye that a float may take it for behind.
inline bool enters_at_eye(const Path& path, const PathHits& hits) {
    constexpr float unsure = 0x1p-16F;  // of the way through the cell
    const auto eye = static_cast<float>(-path.start_base);
    for (int level = 0; level < path.shared; ++level) {
        const float through = hits.exit[level] - hits.key[level];
        if (std::abs(hits.key[level] - eye) <= unsure * through) return true;
    }
    return false;
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
    const TileView& tile = work.tile;
    PathHits hits;
    hit_path(tile, *path, levels, ray, object.spheres, PathSide::entry, hits);
    if (!path->deep && enters_at_eye(*path, hits)) {
        path->deep = true;
        hit_path(tile, *path, levels, ray, object.spheres, PathSide::entry, hits);
    }
    float depth = 0;
    if (!confirm(scene, work, *path, levels, ray, hits, depth)) return false;
    const Visited visited = visited_levels(*path, levels, scene.shading, hits);
    if (visited.leaves) hit_path(tile, *path, levels, ray, object.spheres, PathSide::exit, hits);
    const PathWeights weights{scene.shading, path->rows[Path::diameter][0]};
    const glm::vec3 normal = to_scene(tile, total_normal(*path, weights, visited, hits));
    glm::vec3 sum{scene.ambient[0], scene.ambient[1], scene.ambient[2]};
    for (const CompiledLight& light : scene.lights) {  // Eq. 17.1
        const float facing = light.kind == kernels::LightKind::directional
                                 ? glm::dot(normal, glm::vec3{light.place})
                                 : facing_point_light(tile, *path, weights, visited, hits, ray,
                                                      to_tile(tile, light.place));
        if (facing > 0) sum += object.diffuse * facing * glm::vec3{light.color};
    }
    shaded.color = {sum.x * color[0], sum.y * color[1], sum.z * color[2]};
    shaded.normal = {normal.x, normal.y, normal.z};
    shaded.t = static_cast<float>((path->start_base + static_cast<double>(depth)) *
                                  static_cast<double>(tile.stretch[ray]));
    shaded.object = path->object;
    shaded.level = levels - 1;
    const std::uint32_t folded = (hash >> 24 ^ hash) & 0x00FF'FFFF;
    shaded.word = folded == 0 ? 1 : folded;
    return true;
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
