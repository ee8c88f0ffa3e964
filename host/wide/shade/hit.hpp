// What rays see of the cells that they have found (Ch. 17), and the paths of cells that it comes
// from: the levels that rays share, and those of a ray's own.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace pxm::host::wide {

/// What a word of symbols gives, beside a cell.
struct HitWord {
    std::uint32_t hash;  // unfinished
    std::array<float, 3> color;
};

/// The cells on the way from an object to an entry cell: the same for all rays that hit below it.
/// A row for each level, the object's first.
struct Path {
    static constexpr int capacity = 128;  // levels; deeper hits are left to the reference kernels
    static constexpr int map = 0;         // 12: U, V, W, o (SharedCell); of homotheties 5: centre,
                                          // size and its inverse, in the packet's frame (balls) or
                                          // the object's unit coordinates from the entry cell's
                                          // centre (boxes)
    static constexpr int base = 12;
    static constexpr int from_start = 13;  // base less the entry cell's
    static constexpr int diameter = 14;
    static constexpr int row_length = 16;

    alignas(64) float rows[capacity][row_length];
    alignas(64) double f64[capacity][row_length];  // the same, used if deep
    bool deep = false;  // a float cannot tell where rays enter the largest cells
    double start_base = 0;
    double start_diameter = 0;
    int object = 0;
    int shared = 0;  // levels
    HitWord word{};  // of the shared symbols
    /// Of homotheties, or of maps that turn.
    enum class Kind { balls, boxes, balls_of_maps, boxes_of_maps };
    Kind kind = Kind::balls;
    // Of boxes: U, V, W, o of a cell at the entry cell's place, as large as the object, and the
    // normals of its faces in the packet's frame.
    std::array<double, 12> frame{};
    std::array<glm::dvec3, 3> face{};
    std::uint64_t rays = 0;  // that are to be looked at
};

/// What a ray sees of a cell.
struct ShadedHit {
    std::array<float, 3> color;   // of the surface, without light
    std::array<float, 3> normal;  // the total normal, scene coordinates
    std::vector<float> facing;    // of each light: Lambert's cosine, or its mean over the path
    double depth;                 // along the packet's axis
    int object;
    int level;
    std::uint32_t word;  // hash
};

/// Rays that have hit below the same entry cell, one in each lane.
struct HitLanes {
    static constexpr int most_lanes = 16;

    int count = 0;
    std::array<int, most_lanes> rays{};
    alignas(64) float beside[4][most_lanes] = {};   // u0, u1, v0, v1
    alignas(64) float begin[most_lanes] = {};       // depth at which the ray begins
    alignas(64) float start[most_lanes] = {};       // the same from the entry cell's base
    alignas(64) float pixel_base[most_lanes] = {};  // detail * p is base + growth * depth
    alignas(64) float pixel_growth[most_lanes] = {};
    alignas(64) std::int32_t levels[most_lanes] = {};
    std::array<HitWord, most_lanes> words{};
    // Levels of a ray's own, seen from the entry cell: centre and size, or an affine map.
    alignas(64) float map[Path::capacity][12][most_lanes] = {};
    alignas(64) float diameter[Path::capacity][most_lanes] = {};
    // At each level the key and the exit, from the entry cell's base, and the normal.
    alignas(64) float hits[Path::capacity][5][most_lanes] = {};
    bool enclosed = false;
    // What cells around the object give, if there are any: weighted and plain sum of normals, sum
    // of weights.
    alignas(64) float enclosing[7][most_lanes] = {};
    alignas(64) float depth[most_lanes] = {};  // of the last cell, from the entry cell's base
    alignas(64) float normal[3][most_lanes] = {};
};

}  // namespace pxm::host::wide
