// The first cells that the 64 rays of a bundle meet. Three steps, one file each:
//   shared_levels.inl  the bundle as a whole goes down to *start cells* of a few pixels, nearest
//                          first, in double
//   start_cell.inl     the bundle's rays, in lanes, against a start cell, in float
//   single_ray.inl     each ray that meets it alone, with a cell's children in lanes
// A workspace is one thread's; its memory does not grow with the picture, and cells that are too
// small for the pixels of a tile do not fill it: beyond most_shared_cells, or a full arena, the
// rays that have not found anything yet are left to the clear kernels.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "host/wide/aspect.hpp"
#include "host/wide/enclosing.hpp"
#include "host/wide/ray_bundle.hpp"
#include "host/wide/seen_cells.hpp"
#include "host/wide/wide_scene.hpp"

namespace pxm::host::wide {

inline constexpr std::size_t most_shared_cells = std::size_t{1} << 17;  // of a bundle

/// A cell that the bundle's rays share, as seen from the bundle. A point of a ray at depth z is
/// o + (z - base) W + u U + v V in the cell's unit coordinates; o is near the volume's centre.
struct SharedCell {
    std::array<double, 12> rows;   // U, V, W, o
    std::array<double, 9> linear;  // composed linear part (polar)
    double constant = 1;           // Lipschitz constant of the composed map (otherwise)
    double diameter = 0;           // in scene units
    double base = 0;
    double near = 0;  // all rays of the bundle are within this interval of depths
    double far = 0;   // while they are in the cell
    int set = 0;
    int object = 0;
    int parent = -1;
    int symbol = 0;
    std::uint32_t level = 0;
    bool spheres = true;  // its own volume
    int path = -1;        // index of its path, once a ray has hit below it
};

/// A shared cell of homotheties: its centre and its size. For balls in the bundle's frame and scene
/// units, z along the axis; for boxes in the unit coordinates of the object.
struct FixedCell {
    std::array<double, 3> center;
    double size;
    double near;
    double far;
    double constant;
    double diameter;
    int set;
    int object;
    int parent;
    int lane;  // in the parent's set
    std::uint32_t level;
    int path;
};

/// What the shared cells of an object of boxes have in common, as seen from the bundle. Along each
/// axis k a ray is at eye[k] + z w[k], more or less spread0[k] + z spread1[k]; kept of the paces
/// are 1 / (w - spread1) and 1 / (-w - spread1).
struct BoxBeam {
    std::array<double, 3> eye, spread0, high_pace, low_pace;
};

/// The shadow that the hull of an object's attractor casts on the plane across the bundle, in radii
/// of its ball: the places (px, py) with x px + y py <= height for each edge. No edges: no cull.
struct HullShadow {
    static constexpr int most_edges = 6;
    int edges = 0;
    template <class T>
    struct Edge {
        T x, y, height;
    };
    std::array<Edge<double>, most_edges> twice;
    std::array<Edge<float>, most_edges> single;  // the same

    void put(int edge, const Edge<double>& at) {
        const auto i = static_cast<std::size_t>(edge);
        twice[i] = at;
        single[i] = {static_cast<float>(at.x), static_cast<float>(at.y),
                     static_cast<float>(at.height)};
    }
    template <class T>
    [[nodiscard]] const Edge<T>& edge(int i) const {
        const auto at = static_cast<std::size_t>(i);
        if constexpr (std::is_same_v<T, float>) {
            return single[at];
        } else {
            return twice[at];
        }
    }
};

/// The children of a cell below a start cell, in lanes; shared by the rays that open it.
/// Rows: from the start cell's unit coordinates to the children's (12), their diameters, their
/// constants, and where the Lipschitz method needs them their composed linear parts (9).
struct Block {
    static constexpr int map = 0;
    static constexpr int diameter = 12;
    static constexpr int constant = 13;
    static constexpr int linear = 14;
    static constexpr int product_rows = 14;
    static constexpr int polar_rows = 23;

    int set = 0;
    int parent = -1;          // block; -1: the start cell
    int lane = 0;             // in the parent block
    std::uint32_t level = 0;  // of the children
    bool last = false;        // they are terminal whatever their size
    float* rows = nullptr;
    int* opened = nullptr;  // the block of each child, or -1
};

/// What a ray was found to meet first: the cell in `lane` of `block`, or the start cell itself.
struct Found {
    int start = -1;  // index of a shared cell; -1: nothing
    int block = -1;
    int lane = 0;
    double depth = 0;
    std::uint32_t tested = 0;  // volumes tested for this ray alone
    bool given_up =
        false;  // too many of them, or it lies in the face of a box: for the clear kernels

    /// Nothing found yet; `below` is left as it is.
    void clear() {
        start = -1;
        block = -1;
        depth = 0;
        tested = 0;
        given_up = false;
        below_count = -1;
    }
    // Below a start cell of homotheties (`start` is a fixed cell), instead of a block: lanes in the
    // sets' tables.
    static constexpr int most_below = 30;
    int below_count = -1;  // -1: a block and a lane
    std::array<std::uint16_t, most_below> below;
};

/// Floats and ints that live until the bundle is done: 128 MiB until it is full, and a cell more.
class Arena {
  public:
    void clear() {
        chunk_ = 0;
        used_ = 0;
    }
    /// Room for so many floats, a multiple of table_step.
    [[nodiscard]] float* floats(std::size_t count);
    [[nodiscard]] int* ints(std::size_t count) { return reinterpret_cast<int*>(floats(count)); }
    [[nodiscard]] bool is_full() const { return chunk_ >= most_chunks; }

  private:
    static constexpr std::size_t chunk_floats = std::size_t{1} << 18;
    static constexpr std::size_t most_chunks = 128;
    std::vector<hwy::AlignedFreeUniquePtr<float[]>> chunks_;
    std::size_t chunk_ = 0;
    std::size_t used_ = 0;
};

/// What a ray has met of up to `room` cells.
struct MetCells {
    static constexpr int room = 64;

    alignas(64) float key[room];
    int count;               // cells that were tested
    std::uint64_t waiting;   // those that were met and not looked into, a bit each
    std::uint64_t terminal;  // these are terminal if they are met
};

/// What a ray has met of the children in a block, those from `first` on.
struct MetChildren : MetCells {
    alignas(64) float exit[room];
    int block;
    int first;
};

/// Where a cell of homotheties is seen from a ray: for balls the centre beside the ray and its
/// depth, for boxes the depth at which the ray passes the centre's plane across each axis.
struct PlaceBelow {
    float x;
    float y;
    float z;
    float size;  // to the start cell's
};

/// A cell of homotheties that a ray has opened, and what it met inside.
struct OpenedCell : MetCells {
    alignas(64) float x[room];  // PlaceBelow
    alignas(64) float y[room];
    alignas(64) float z[room];
    alignas(64) float size[room];
    const HomothetyTable* table;
    const std::int32_t* lane;  // of each cell, in the table
    int taken;                 // the cell that was gone into
    std::uint32_t levels_left;
    float constant;  // Lipschitz constant of the composed map
    int set;
    bool in_face;  // the ray lies in the face of a box: floats cannot tell what it meets
};

/// A start cell as the bundle's rays see it, and what the rays below it need.
struct StartRays {
    alignas(64) float origin[3][bundle_rays];
    alignas(64) float direction[3][bundle_rays];
    alignas(64) float key[bundle_rays];
    alignas(64) float exit[bundle_rays];
    int cell = 0;
    int block = -1;  // of its children, once opened
    double base = 0;
};

/// The rays of the bundle in the frame of their aspect.
struct AspectRays {
    alignas(64) float a[bundle_rays];  // sideways per depth
    alignas(64) float b[bundle_rays];
    alignas(64) float shrink2[bundle_rays];  // 1 / (1 + a^2 + b^2)
    alignas(64) float pace[bundle_rays];     // depth in this frame per depth in the bundle's
    float turn[3][3];                        // the bundle's axes in this frame
    Aspect* aspect = nullptr;
    std::uint64_t made_for = 0;  // the bundle's number
};

struct Workspace {
    void clear_found() {
        for (Found& ray : found) ray.clear();
    }

    RayBundle bundle;
    std::vector<SharedCell> cells;
    std::vector<FixedCell> fixed_cells;
    std::vector<BoxBeam> box_beams;             // per object
    std::vector<HullShadow> shadows;            // per object
    std::vector<std::pair<double, int>> queue;  // (near, cell or ~fixed cell), a heap
    std::vector<Block> blocks;
    Arena arena;
    StartRays start;
    std::vector<MetChildren> met;                      // of blocks, one below the other
    std::array<OpenedCell, Found::most_below> opened;  // one below the other
    std::vector<LaneTable<double>> turned;             // children's centres in the bundle's frame
    std::vector<std::uint64_t> turned_for;             // (bundle, turn) they are right for
    std::uint64_t bundle_number = 0;
    std::vector<Aspect> aspects;  // of the bundle itself, of a part of the picture, of each light
    AspectRays aspect_rays;
    bool looking = false;  // a start cell has been given to the rays: `found` is theirs
    std::array<Found, bundle_rays> found;
    /// What lies beyond is of no interest to a ray: where it found a cell, or where it ends.
    std::array<double, bundle_rays> best;
    double farthest = 0;   // of all rays inside, when last looked for
    bool improved = true;  // since then
    std::uint64_t shared_tests = 0;
    std::vector<Path> paths;
    std::size_t paths_used = 0;
    SeenTogether seen_together;
    std::vector<EnclosingNormal> enclosing;       // of the ray that is being looked at
    hwy::AlignedFreeUniquePtr<double[]> scratch;  // children of a shared cell, in lanes
};

/// Fills in `found` for the bundle in the workspace, on the widest registers there are. False, and
/// nothing filled in, if the bundle came to no start cell: none of its rays meets anything.
[[nodiscard]] bool search_bundle(const WideScene& scene, Workspace& work);

/// Looks at what rays of the bundle have found, a bit each, and fills in `seen[ray]`. Returns those
/// whose walk along the path confirms it in float: of the others the clear kernels are to judge.
[[nodiscard]] std::uint64_t see_cells(const WideScene& scene, Workspace& work, std::uint64_t rays,
                                      SeenCell* const* seen);

}  // namespace pxm::host::wide
