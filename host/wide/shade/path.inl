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
#include <vector>

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

/// A word goes on with a child of a set.
inline void append(HitWord& word, const WideSet& set, std::size_t child, bool colored) {
    word.hash = hash_symbol(word.hash, static_cast<std::uint32_t>(set.maps[child]));
    if (colored) blend(word.color, set.colors[child]);
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
    const WideObject& first = scene.objects[static_cast<std::size_t>(object)];
    path.word = {first.hash, first.color};
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

/// The cells of any maps, as their paths have them.
struct MapCells {
    static std::vector<SharedCell>& all(Workspace& work) { return work.cells; }
    static void begin(const WideObject& object, const RayPacket& /*packet*/,
                      const SharedCell& entry, Path& path) {
        path.kind = object.spheres ? Path::Kind::balls_of_maps : Path::Kind::boxes_of_maps;
        path.start_base = entry.base;
    }
    static double base(const Path& /*path*/, const SharedCell& cell) { return cell.base; }
    static void fill(const Path& /*path*/, const SharedCell& /*entry*/, const SharedCell& cell,
                     double* row) {
        std::ranges::copy(cell.rows, row);
    }
};

/// Those of homotheties.
struct HomothetyCells {
    static std::vector<HomothetyCell>& all(Workspace& work) { return work.homothety_cells; }
    static void begin(const WideObject& object, const RayPacket& packet, const HomothetyCell& entry,
                      Path& path) {
        path.kind = object.spheres ? Path::Kind::balls : Path::Kind::boxes;
        path.start_base = entry.center[2];
        if (!object.spheres) put_frame(object, packet, entry, path);
    }
    static double base(const Path& path, const HomothetyCell& cell) {
        return path.kind == Path::Kind::balls ? cell.center[2] : path.start_base;
    }
    static void fill(const Path& path, const HomothetyCell& entry, const HomothetyCell& cell,
                     double* row) {
        for (std::size_t k = 0; k < 3; ++k) {
            row[k] = cell.center[k] - (path.kind == Path::Kind::balls ? 0 : entry.center[k]);
        }
        row[3] = cell.size;
        row[4] = 1 / cell.size;
    }
};

/// The path of an entry cell, its shared levels filled in. Null if it is too long.
template <class Cells>
inline Path* path_of(const WideScene& scene, Workspace& work, int start) {
    auto& cells = Cells::all(work);
    auto& entry = cells[static_cast<std::size_t>(start)];
    if (entry.level + 1 > Path::capacity) return nullptr;
    if (entry.path >= 0) return &work.paths[static_cast<std::size_t>(entry.path)];
    Path& path = new_path(scene, work, entry.object, entry.level, entry.path);
    const WideObject& object = scene.objects[static_cast<std::size_t>(entry.object)];
    Cells::begin(object, work.packet, entry, path);
    path.start_diameter = entry.diameter;
    int way[Path::capacity];
    int at = start;
    for (int level = path.shared - 1; level >= 0; --level) {
        way[level] = at;
        at = cells[static_cast<std::size_t>(at)].parent;
    }
    for (int level = 0; level < path.shared; ++level) {
        const auto& cell = cells[static_cast<std::size_t>(way[level])];
        put_level(path, level, Cells::base(path, cell), cell.diameter,
                  [&](double* row) { Cells::fill(path, entry, cell, row); });
        if (level == 0) continue;
        const auto& parent = cells[static_cast<std::size_t>(cell.parent)];
        append(path.word, scene.sets[static_cast<std::size_t>(parent.set)],
               static_cast<std::size_t>(cell.lane), object.colored);
    }
    return &path;
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
