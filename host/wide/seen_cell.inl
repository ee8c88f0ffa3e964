// What a ray sees of the cell it has found (Ch. 17), from the levels of its path. The same walk
// checks what the search skipped: that the ray meets every cell of the path within its parent's
// interval, and that none but the last is terminal. As in dsp_kernels/shade.hpp and lights.hpp.
#if defined(PXM_HOST_WIDE_SEEN_CELL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEEN_CELL_INL
#undef PXM_HOST_WIDE_SEEN_CELL_INL
#else
#define PXM_HOST_WIDE_SEEN_CELL_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host/wide/enclosing.hpp"
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

/// What a ray finds out on its way along a path.
struct PathWalk {
    float depth = 0;        // of the last cell, from the start cell's base
    glm::vec3 weighted{0};  // sum of the normals, by their weights
    glm::vec3 plain{0};     // the same, each counted once
    float total = 0;        // of the weights
    int visited = 0;        // levels that gave a normal: those that the ray enters
    bool unsure = false;    // a shared cell is entered so near the ray's start that a float
                            // may take it for behind

    void add(const PathHits& hits, int level, float weight) {
        add({hits.normal[0][level], hits.normal[1][level], hits.normal[2][level]}, weight);
    }
    void add(const glm::vec3& normal, float weight) {
        weighted += weight * normal;
        plain += normal;
        total += weight;
        ++visited;
    }
    /// The total normal (Eq. 17.3). When all weights vanish, they are all 1 (Erratum 18).
    [[nodiscard]] glm::vec3 normal() const {
        const glm::vec3 sum = total > 0 ? weighted : plain;
        return sum / std::sqrt(glm::dot(sum, sum));
    }
};

/// A ray along a path, in depths from the start cell's base; p as in FixedRay.
struct PathRay {
    float start;
    float pixel_base;
    float pixel_growth;
    float pixel_least;
    std::uint32_t last_level;  // of the object

    PathRay(const WideScene& scene, const Workspace& work, const Path& path, int ray)
        : last_level(scene.objects[static_cast<std::size_t>(path.object)].levels) {
        const WideObject& object = scene.objects[static_cast<std::size_t>(path.object)];
        const auto growth = static_cast<double>(work.bundle.pixel1[ray]);
        const double p = static_cast<double>(work.bundle.pixel0[ray]) + growth * path.start_base;
        start = static_cast<float>(static_cast<double>(work.bundle.start[ray]) - path.start_base);
        pixel_base = static_cast<float>(scene.detail * p);
        pixel_growth = static_cast<float>(scene.detail * growth);
        pixel_least = static_cast<float>(scene.detail * object.smallest_pixel);
    }
    [[nodiscard]] bool is_terminal(int level, float diameter, float key) const {
        return static_cast<std::uint32_t>(level) == last_level ||
               diameter <= std::max(pixel_base + pixel_growth * key, pixel_least);
    }
};

/// Whether a level gives a normal: the ray enters it, and is not asked for the last one alone.
inline bool gives_normal(const PathRay& ray, const PathHits& hits, int level, int levels,
                         kernels::ShadingMode mode) {
    return ray.start < hits.key[level] &&
           (mode != kernels::ShadingMode::facet || level == levels - 1);
}

/// Walks the path: false unless the ray meets every cell, and the last one alone is terminal.
inline bool walk_path(const PathRay& ray, const Path& path, int levels, const PathWeights& weights,
                      const PathHits& hits, PathWalk& walk) {
    constexpr float close = 0x1p-16F;  // of the way through the cell
    float key = ray.start;
    float exit = std::numeric_limits<float>::infinity();
    for (int level = 0; level < levels; ++level) {
        const float entry = hits.key[level];
        const float through = hits.exit[level] - entry;
        if (!(through >= 0)) return false;  // NaN as well
        key = std::max(key, entry);
        exit = std::min(exit, hits.exit[level]);
        if (exit < key) return false;
        const float diameter = path.rows[Path::diameter][level];
        if (ray.is_terminal(level, diameter, key) != (level == levels - 1)) return false;
        if (level < path.shared && std::abs(entry - ray.start) <= close * through) {
            walk.unsure = true;
        }
        if (gives_normal(ray, hits, level, levels, weights.mode)) {
            walk.add(hits, level, weights.of(diameter));
        }
    }
    walk.depth = key;
    return true;
}

/// How much a place faces a point light: the weighted mean over the cells of its path, each by
/// itself (Eq. 17.3 in full, as dsp_kernels/lights.hpp). `light` in the bundle's frame.
class PointLightSum {
  public:
    PointLightSum(const RayBundle& bundle, const Path& path, int ray, const glm::dvec3& light)
        : bundle_(bundle), path_(path), ray_(ray), light_(light) {}
    void add(const PathHits& hits, int level, float depth, float weight) {
        add({hits.normal[0][level], hits.normal[1][level], hits.normal[2][level]},
            path_.start_base + static_cast<double>(depth), weight);
    }
    void add(const glm::vec3& normal, double z, float weight) {
        const auto at = [&](const float* constant, const float* growing) {
            return static_cast<double>(constant[ray_]) + static_cast<double>(growing[ray_]) * z;
        };
        const glm::dvec3 point{at(bundle_.u0, bundle_.u1), at(bundle_.v0, bundle_.v1), z};
        const glm::vec3 toward{glm::normalize(light_ - point)};
        const float cosine = std::max(0.0F, glm::dot(normal, toward));
        weighted_ += weight * cosine;
        plain_ += cosine;
        total_ += weight;
        ++count_;
    }
    [[nodiscard]] float mean() const {
        return total_ > 0 ? weighted_ / total_ : plain_ / static_cast<float>(count_);
    }

  private:
    const RayBundle& bundle_;
    const Path& path_;
    int ray_;
    glm::dvec3 light_;
    float weighted_ = 0;
    float plain_ = 0;
    float total_ = 0;
    int count_ = 0;
};

/// The bundle's frame to scene units.
inline glm::vec3 to_scene(const RayBundle& bundle, const glm::vec3& v) {
    return glm::vec3{bundle.axis[0]} * v.x + glm::vec3{bundle.axis[1]} * v.y +
           glm::vec3{bundle.axis[2]} * v.z;
}

inline glm::dvec3 to_frame(const RayBundle& bundle, const glm::dvec3& v) {
    return {glm::dot(v, bundle.axis[0]), glm::dot(v, bundle.axis[1]), glm::dot(v, bundle.axis[2])};
}

/// How much of each light the place would get if nothing stood in between.
inline void face_lights(const WideScene& scene, const Workspace& work, const PathRay& path_ray,
                        const Path& path, int levels, int ray, const PathWeights& weights,
                        const PathHits& hits, const PathWalk& walk, SeenCell& seen) {
    const glm::vec3 normal{seen.normal[0], seen.normal[1], seen.normal[2]};
    seen.facing.resize(scene.lights.size());
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {  // Eq. 17.1
        const CompiledLight& light = scene.lights[i];
        if (light.kind == kernels::LightKind::directional) {
            seen.facing[i] = std::max(0.0F, glm::dot(normal, glm::vec3{light.place}));
            continue;
        }
        PointLightSum sum(work.bundle, path, ray,
                          to_frame(work.bundle, light.place - work.bundle.origin));
        for (const EnclosingNormal& cell : work.enclosing) {
            sum.add(cell.normal, cell.depth, weights.of(cell.diameter));
        }
        for (int level = 0; level < levels; ++level) {
            const bool leaves = walk.visited == 0 && level == levels - 1;
            if (!leaves && !gives_normal(path_ray, hits, level, levels, weights.mode)) continue;
            sum.add(hits, level, leaves ? hits.exit[level] : hits.key[level],
                    weights.of(path.rows[Path::diameter][level]));
        }
        seen.facing[i] = sum.mean();
    }
}

inline bool see(const WideScene& scene, Workspace& work, int ray, SeenCell& seen) {
    const Found& found = work.found[static_cast<std::size_t>(ray)];
    Path* path = found.below_count >= 0 ? path_of_fixed(scene, work, found.start)
                                        : path_of(scene, work, found.start);
    if (path == nullptr) return false;
    const WideObject& object = scene.objects[static_cast<std::size_t>(path->object)];
    std::uint32_t hash = 0;
    const int levels = add_own_levels(scene, work, found, *path, hash, seen.color);
    if (levels == 0) return false;
    const RayBundle& bundle = work.bundle;
    const PathRay path_ray(scene, work, *path, ray);
    const PathWeights weights{scene.shading, object.enclosing < 0
                                                 ? path->rows[Path::diameter][0]
                                                 : static_cast<float>(object.widest)};
    find_enclosing(scene, object, bundle, ray, work.enclosing);
    PathWalk enclosing;
    for (const EnclosingNormal& cell : work.enclosing) {
        enclosing.add(cell.normal, weights.of(cell.diameter));
    }
    PathHits hits;
    PathWalk walk = enclosing;
    hit_path(bundle, *path, levels, ray, object.spheres, PathSide::entry, hits);
    bool confirmed = walk_path(path_ray, *path, levels, weights, hits, walk);
    if (!path->deep && walk.unsure) {
        path->deep = true;
        walk = enclosing;
        hit_path(bundle, *path, levels, ray, object.spheres, PathSide::entry, hits);
        confirmed = walk_path(path_ray, *path, levels, weights, hits, walk);
    }
    if (!confirmed) return false;
    PathWalk normals = walk;
    if (walk.visited == 0) {  // the normal where the ray leaves the last cell
        hit_path(bundle, *path, levels, ray, object.spheres, PathSide::exit, hits);
        normals.add(hits, levels - 1, 1);
    }
    const glm::vec3 normal = to_scene(bundle, normals.normal());
    seen.normal = {normal.x, normal.y, normal.z};
    face_lights(scene, work, path_ray, *path, levels, ray, weights, hits, walk, seen);
    seen.depth = path->start_base + static_cast<double>(walk.depth);
    seen.object = path->object;
    seen.level = levels - 1;
    seen.word = folded(hash);
    return true;
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
