// The cells on the way from an object to an entry cell: what shading (Ch. 17) adds up. They are
// made once and serve all rays that hit below it.
#if defined(PXM_HOST_WIDE_SHADE_PATH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SHADE_PATH_INL
#undef PXM_HOST_WIDE_SHADE_PATH_INL
#else
#define PXM_HOST_WIDE_SHADE_PATH_INL
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "host/engine/word_hash.hpp"
#include "host/wide/packet/lanes.inl"
#include "host/wide/search/homothety_levels.inl"
#include "host/wide/shade/shade_hits.hpp"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline void blend(std::array<float, 3>& color, const std::array<float, 4>& paint) {
    const float a = paint[3];
    for (std::size_t i = 0; i < 3; ++i) color[i] = (1 - a) * color[i] + a * paint[i];
}

inline std::size_t child_lane(const WideSet& set, int symbol) {
    const auto found = std::ranges::lower_bound(set.maps, symbol);
    return static_cast<std::size_t>(found - set.maps.begin());
}

/// A path to fill in, for an entry cell at that level.
inline Path& new_path(const WideScene& scene, Workspace& work, int object, std::uint32_t level,
                      int& index) {
    if (work.paths.size() == work.paths_used) work.paths.push_back(Path{});
    index = static_cast<int>(work.paths_used++);
    Path& path = work.paths[static_cast<std::size_t>(index)];
    path.shared = static_cast<int>(level) + 1;
    path.object = object;
    path.rays = 0;
    path.color = scene.objects[static_cast<std::size_t>(object)].color;
    path.hash = scene.objects[static_cast<std::size_t>(object)].hash;
    return path;
}

/// An entry cell that is smaller than this share of its object: a float cannot tell well enough
/// where rays enter the largest cells on its path.
inline constexpr double deep_share = 0x1p-10;

/// Row `level`, of which the first numbers are filled in by `fill(row of doubles)`.
template <class Fill>
inline void put_level(Path& path, int level, double base, double diameter, const Fill& fill) {
    double* f64 = path.f64[level];
    fill(f64);
    f64[Path::base] = base;
    f64[Path::from_start] = base - path.start_base;
    f64[Path::diameter] = diameter;
    for (int i = 0; i <= Path::diameter; ++i) path.rows[level][i] = static_cast<float>(f64[i]);
    if (level == 0) path.deep = diameter * deep_share > path.start_diameter;
}

/// The path of an entry cell, its shared levels filled in. Null if it is too long.
inline Path* path_of(const WideScene& scene, Workspace& work, int start) {
    SharedCell& cell = work.cells[static_cast<std::size_t>(start)];
    if (cell.level + 1 > Path::capacity) return nullptr;
    if (cell.path >= 0) return &work.paths[static_cast<std::size_t>(cell.path)];
    Path& path = new_path(scene, work, cell.object, cell.level, cell.path);
    path.kind = scene.objects[static_cast<std::size_t>(cell.object)].spheres
                    ? Path::Kind::balls_of_maps
                    : Path::Kind::boxes_of_maps;
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
        put_level(path, level, inner.base, inner.diameter,
                  [&](double* row) { std::ranges::copy(inner.rows, row); });
        if (level == 0) continue;
        path.hash = hash_symbol(path.hash, static_cast<std::uint32_t>(inner.symbol));
        if (!scene.objects[static_cast<std::size_t>(cell.object)].colored) continue;
        const SharedCell& parent = work.cells[static_cast<std::size_t>(inner.parent)];
        const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
        blend(path.color, set.colors[child_lane(set, inner.symbol)]);
    }
    return &path;
}

/// What the boxes of a path have in common.
inline void put_frame(const WideObject& object, const RayPacket& packet, const HomothetyCell& start,
                      Path& path) {
    HomothetyCell unit = start;
    unit.size = 1;
    rows_of(object, packet, unit, path.frame, path.start_base);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 across{path.frame[k], path.frame[3 + k], path.frame[6 + k]};
        path.face[k] = glm::normalize(across);
    }
}

/// The same for homotheties.
inline Path* path_of_homotheties(const WideScene& scene, Workspace& work, int start) {
    HomothetyCell& cell = work.homothety_cells[static_cast<std::size_t>(start)];
    if (cell.level + 1 > Path::capacity) return nullptr;
    if (cell.path >= 0) return &work.paths[static_cast<std::size_t>(cell.path)];
    Path& path = new_path(scene, work, cell.object, cell.level, cell.path);
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    path.kind = object.spheres ? Path::Kind::balls : Path::Kind::boxes;
    if (object.spheres) {
        path.start_base = cell.center[2];
    } else {
        put_frame(object, work.packet, cell, path);
    }
    path.start_diameter = cell.diameter;
    int cells[Path::capacity];
    int at = start;
    for (int level = path.shared - 1; level >= 0; --level) {
        cells[level] = at;
        at = work.homothety_cells[static_cast<std::size_t>(at)].parent;
    }
    for (int level = 0; level < path.shared; ++level) {
        const HomothetyCell& inner = work.homothety_cells[static_cast<std::size_t>(cells[level])];
        const double base = object.spheres ? inner.center[2] : path.start_base;
        put_level(path, level, base, inner.diameter, [&](double* row) {
            for (std::size_t k = 0; k < 3; ++k) {
                row[k] = inner.center[k] - (object.spheres ? 0 : cell.center[k]);
            }
            row[3] = inner.size;
            row[4] = 1 / inner.size;
        });
        if (level == 0) continue;
        const HomothetyCell& parent = work.homothety_cells[static_cast<std::size_t>(inner.parent)];
        const WideSet& set = scene.sets[static_cast<std::size_t>(parent.set)];
        const auto lane = static_cast<std::size_t>(inner.lane);
        path.hash = hash_symbol(path.hash, static_cast<std::uint32_t>(set.maps[lane]));
        if (object.colored) blend(path.color, set.colors[lane]);
    }
    return &path;
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
