// The first cells that the 64 rays of a tile meet. Three steps, one file each:
//   shared_levels.inl  the tile as a whole goes down to *start cells* of a few pixels, nearest
//                          first, in double
//   start_cell.inl     the tile's rays, in lanes, against a start cell, in float
//   single_ray.inl     each ray that meets it alone, with a cell's children in lanes
// A workspace is one thread's; its memory does not grow with the picture.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host/wide/tile_view.hpp"
#include "host/wide/wide_scene.hpp"

namespace pxm::host::wide {

/// A cell that the tile's rays share, as seen from the tile. A point of a ray at depth z is
/// o + (z - base) W + u U + v V in the cell's unit coordinates; o is near the volume's centre.
struct SharedCell {
    std::array<double, 12> rows;   // U, V, W, o
    std::array<double, 9> linear;  // composed linear part (polar)
    double constant = 1;           // Lipschitz constant of the composed map (otherwise)
    double diameter = 0;           // in scene units
    double base = 0;
    double near = 0;  // all rays of the tile are within this interval of depths
    double far = 0;   // while they are in the cell
    int set = 0;
    int object = 0;
    int parent = -1;
    int symbol = 0;
    std::uint32_t level = 0;
    bool spheres = true;  // its own volume
    int path = -1;        // index of its path, once a ray has hit below it
};

/// A shared cell of homotheties: its centre and its size. For balls in the tile's frame and scene
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

/// What the shared cells of an object of boxes have in common, as seen from the tile. Along each
/// axis k a ray is at eye[k] + z w[k], more or less spread0[k] + z spread1[k]; kept of the paces
/// are 1 / (w - spread1) and 1 / (-w - spread1).
struct BoxBeam {
    std::array<double, 3> eye, spread0, high_pace, low_pace;
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
    bool given_up = false;     // too many of them

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

/// Floats and ints that live until the tile is done.
class Arena {
  public:
    void clear() {
        chunk_ = 0;
        used_ = 0;
    }
    /// Room for so many floats, a multiple of table_step.
    [[nodiscard]] float* floats(std::size_t count);
    [[nodiscard]] int* ints(std::size_t count) { return reinterpret_cast<int*>(floats(count)); }

  private:
    static constexpr std::size_t chunk_floats = std::size_t{1} << 18;
    std::vector<hwy::AlignedFreeUniquePtr<float[]>> chunks_;
    std::size_t chunk_ = 0;
    std::size_t used_ = 0;
};

/// A cell on a ray's stack.
struct Waiting {
    float key;
    float exit;
    int block;
    int lane;
};

/// A cell of homotheties that a ray opened: for balls the centre beside the ray and its depth, for
/// boxes the depth of the centre along each axis.
struct Opened {
    float x;
    float y;
    float z;
    float size;      // of the cell, to the start cell
    float constant;  // Lipschitz constant of the composed map
    int set;
    int parent;  // in the list of opened cells
    int lane;    // in the parent's table
    int level;   // below the start cell
    bool two;    // its grandchildren were tested at once
};

/// A start cell as the tile's rays see it, and what the rays below it need.
struct StartRays {
    alignas(64) float origin[3][tile_rays];
    alignas(64) float direction[3][tile_rays];
    alignas(64) float key[tile_rays];
    alignas(64) float exit[tile_rays];
    int cell = 0;
    int block = -1;  // of its children, once opened
    double base = 0;
};

/// The cells on the way from an object to a hit: one in each lane, the start cell and what is
/// outside it first, the same for all rays that hit below it.
struct Path {
    static constexpr int capacity = 128;  // levels; deeper hits are left to the clear kernels
    static constexpr int map = 0;         // 12: U, V, W, o
    static constexpr int base = 12;
    static constexpr int from_start = 13;  // base less the start cell's
    static constexpr int diameter = 14;
    static constexpr int row_count = 15;

    alignas(64) float rows[row_count][capacity];
    alignas(64) double twice[base + 1][capacity];  // of shared levels; used if deep
    bool deep = false;
    double start_base = 0;
    double start_diameter = 0;
    int object = 0;
    int shared = 0;          // levels that all rays share; those of a single ray follow
    std::uint32_t hash = 0;  // of the shared symbols, unfinished
    std::array<float, 3> color{};
};

/// A hit as the picture wants it.
struct Shaded {
    std::array<float, 3> color;
    std::array<float, 3> normal;
    float t;  // scene units
    int object;
    int level;
    std::uint32_t word;
};

/// Of p: what is nearer by less may be passed over. Decision 4 allows all of p; the rest is for
/// rounding.
inline constexpr float allowed_share = 0.0F;

struct Workspace {
    TileView tile;
    std::vector<SharedCell> cells;
    std::vector<FixedCell> fixed_cells;
    std::vector<BoxBeam> box_beams;             // per object
    std::vector<std::pair<double, int>> queue;  // (near, cell or ~fixed cell), a heap
    std::vector<Block> blocks;
    Arena arena;
    StartRays start;
    std::vector<Waiting> stack;
    std::vector<Opened> opened;
    std::vector<LaneTable<float>> turned;  // homothety tables in the tile's frame
    std::vector<LaneTable<double>> turned_twice;
    std::vector<std::uint64_t> turned_for;  // (tile, object) they are right for
    std::uint64_t tile_number = 0;
    std::array<Found, tile_rays> found;
    /// What lies beyond is of no interest to a ray: where it found a cell, less the share of p that
    /// decision 4 allows; else infinity.
    std::array<double, tile_rays> best;
    double farthest = 0;   // of all rays inside, when last looked for
    bool improved = true;  // since then
    std::uint64_t shared_tests = 0;
    std::vector<Path> paths;
    std::size_t paths_used = 0;
    hwy::AlignedFreeUniquePtr<double[]> scratch;  // children of a shared cell, in lanes
};

/// Fills in `found` for the tile in the workspace, on the widest registers there are.
void search_tile(const WideScene& scene, Workspace& work);

/// Shades what a ray of the tile has found. False if the walk along the path does not confirm it in
/// float: the clear kernels are to judge.
[[nodiscard]] bool shade_hit(const WideScene& scene, Workspace& work, int ray, Shaded& shaded);

}  // namespace pxm::host::wide
