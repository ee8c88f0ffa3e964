// A compiled scene as tables for wide registers: for every follow set the maps that may come next,
// one in each lane. Cells have *unit coordinates*, in which their volume is the unit ball or the
// cube [-1,1]^3: going from a cell to its child is one affine map K between unit coordinates,
// whatever the volumes are (steps 2.4.1 to 2.4.3 of Alg. 12.4).
#pragma once

#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/wide/tables/child_grid.hpp"
#include "host/wide/tables/common_grid.hpp"

namespace pxm::host::wide {

inline constexpr std::size_t most_maps = 1024;  // of an object
inline constexpr int table_step = 16;  // children are padded to multiples of the widest register

/// Cells that a ray keeps of one that it has opened, and levels that it goes down below an entry
/// cell: what tables are made for.
inline constexpr int opened_cell_room = 64;
inline constexpr int most_levels_below = 30;

/// What is tabulated of a child, one row of the table each: K, the map's linear part, the rest.
struct ChildField {
    static constexpr int linear = 0;     // 9: K's linear part by rows
    static constexpr int offset = 9;     // 3: K's translation
    static constexpr int forward = 12;   // 9: T_i by rows
    static constexpr int constant = 21;  // of the map, by the shape's Lipschitz method
    static constexpr int diameter = 22;  // of the child's volume
    static constexpr int count = 23;
};

/// Rows of numbers, each a multiple of table_step long and aligned for every register.
template <class T>
class LaneTable {
  public:
    LaneTable() = default;
    LaneTable(int rows, int stride) : stride_(stride) {
        const auto size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(stride);
        if (size == 0) return;  // an object without maps
        data_ = hwy::AllocateAligned<T>(size);
        std::fill_n(data_.get(), size, T(0));
    }
    [[nodiscard]] bool empty() const { return data_ == nullptr; }
    [[nodiscard]] T* row(int i) { return data_.get() + static_cast<std::ptrdiff_t>(i) * stride_; }
    [[nodiscard]] const T* row(int i) const {
        return data_.get() + static_cast<std::ptrdiff_t>(i) * stride_;
    }

  private:
    int stride_ = 0;
    hwy::AlignedFreeUniquePtr<T[]> data_;
};

/// All cells that are so many levels below a cell whose maps are homotheties: where their centres
/// are in the cell's unit coordinates, and how large they are.
struct HomothetyTable {
    static constexpr int most_steps = 6;
    static constexpr int center = 0;    // 3
    static constexpr int scale = 3;     // of the child to the cell
    static constexpr int constant = 4;  // product of the maps' Lipschitz constants
    static constexpr int diameter = 5;  // the same times the diameter of the child's volume
    static constexpr int row_count = 6;

    int count = 0;
    int stride = 0;
    int steps = 1;            // levels down
    float least_skipped = 0;  // diameter of the smallest cell between, if there are any
    float most_diameter = 0;  // of the cells
    std::vector<std::array<std::uint16_t, most_steps>> lanes;  // of each step, in the sets' tables
    std::vector<int> sets;
    LaneTable<float> rows;
    LaneTable<double> f64;  // the same
};

/// What beams need of a child (host/wide/area/area_search.hpp), one row each: F and o, from its
/// unit coordinates to its parent's, the inverse of K; 1 over the half width of its volume along
/// each axis; whether that is a box along the axes.
struct BeamField {
    static constexpr int linear = 0;         // 9
    static constexpr int offset = 9;         // 3
    static constexpr int inverse_half = 12;  // 3
    static constexpr int box = 15;
    static constexpr int count = 16;
};

/// A follow set: its children in lanes, in both widths.
struct WideSet {
    int count = 0;
    int stride = 0;
    bool spheres = true;    // the children's volumes: all balls, or all boxes
    bool polar = false;     // their diameters need the composed linear part (Sec. 16.2)
    std::vector<int> maps;  // symbol of each child
    std::vector<std::array<float, 4>> colors;  // r, g, b, a of each child's map
    std::vector<int> sets;  // follow set of each child, counted through all shapes
    LaneTable<double> f64;
    LaneTable<float> f32;
    LaneTable<double> beams;               // empty unless there are local covers by area
    double coverage = 1;                   // of its volume, by its attractor, on average
    HomothetyTable children;               // empty unless the object is `of_homotheties`
    std::vector<HomothetyTable> composed;  // of two steps, three and so on; not of all sets
    ChildGrid grid;                        // of `children`, if they are boxes in slices
};

/// An object: from scene units to the unit coordinates of its outermost volume.
struct WideObject {
    int index = 0;  // in the compiled scene
    Affine to_unit;
    Affine from_unit;        // its inverse
    double radius = 0;       // of the outermost volume, if it is a ball, in scene units
    glm::dvec3 center{0.0};  // its centre
    glm::dmat3 linear{1.0};  // of the instance
    int set = 0;
    bool spheres = true;
    double constant = 1;
    double diameter = 0;  // of the outermost volume, in the shape's coordinates
    double smallest_pixel = 0;
    std::uint32_t levels = 0;
    std::uint32_t hash = 0;        // of the word that leads to it, unfinished
    int enclosing = -1;            // in the scene's list
    double widest = 0;             // diameter of the outermost cell around it; 0 if none is
    bool colored = false;          // a map has a colour
    glm::dvec3 inverse_half{1.0};  // 1 over the half width of the outermost volume
    bool box = false;              // the outermost volume is a box along the axes
    /// All maps are homotheties whose cells lie in their parents: a ray has the same direction in
    /// all cells (Sec. 13.1), and a cell is known by its centre and its size.
    bool of_homotheties = false;
    bool grid = false;     // and all its sets have their children in slices
    int common_grid = -1;  // the same slices, in WideScene::common_grids; -1: they are not
    int turn = 0;          // of such an object with balls, in WideScene::turns
    std::array<float, 3> color{};
    float diffuse = 0;
    float reflect = 0;
};

struct WideScene {
    std::vector<std::string> why_not;  // of each object of the compiled scene (eligible.hpp)
    std::vector<WideSet> sets;         // of all shapes
    std::vector<WideObject> objects;   // those that the wide engine can do
    /// How objects of homotheties with balls are turned: from scene to unit coordinates, lengths
    /// left.
    std::vector<glm::dmat3> turns;
    std::vector<CommonGrid> common_grids;
    std::size_t composed_cells = 0;  // in the sets' `composed` tables
    std::vector<CompiledEnclosure> enclosures;
    CompiledCamera camera;
    PixelSize size;                // of the whole picture
    long candidate_view_side = 0;  // of its parts (host/wide/tables/candidate_views.hpp)
    double detail = 1;
    std::uint32_t cell_cap = 0;
    double unit = 1;
    kernels::ShadingMode shading = kernels::ShadingMode::constant;
    std::array<float, 3> ambient{};
    std::array<float, 3> background{};
    std::vector<CompiledLight> lights;
};

/// Precondition: some of the objects are eligible (eligible.hpp); the others are left out.
[[nodiscard]] WideScene make_wide_scene(const CompiledScene& scene);

}  // namespace pxm::host::wide
