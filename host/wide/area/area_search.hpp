// Local covers by area (`covers: area`), a tile at a time: what dsp_kernels/beam.hpp does for the
// places of one pixel is done for those of 64 pixels at once. A cell is opened once for the whole
// tile, nearest first; it carries the pixels whose places it may cover, a bit each, and a small
// cell gives each of them its part. A file each:
//   tile_areas.cpp   what a tile's pixels ask for, and the light of what they get
//   tile_view.inl    where cells are seen in the tile's picture, cells in lanes
//   places.inl       a cell and the places of a pixel, places in lanes
//   area_levels.inl  the way down from cells to the small ones, children in lanes
//   area_covers.inl  which places a small cell gets, nearest first
//   area_shade.inl   how a cell is shaded, the levels of its path in lanes
// A workspace is one thread's; its memory does not grow with the picture. It has as many cells as a
// ray may test at most, and no more than most_covered places; then the tile is given up.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dsp_kernels/beam_cell.hpp"
#include "dsp_kernels/sight_list.hpp"
#include "host/wide/packet/ray_packet.hpp"
#include "host/wide/shade/enclosing.hpp"
#include "host/wide/shade/hit.hpp"
#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

inline constexpr int most_places = static_cast<int>(kernels::most_places);
inline constexpr int most_sights = static_cast<int>(kernels::SightList<double>::capacity);

inline constexpr std::size_t most_covered = std::size_t{1} << 22;

/// The rectangle around a cell in the picture.
struct Outline {
    float column, row;    // its middle
    float columns, rows;  // half its size
};

/// A cell as a tile sees it, in scene units from the eye.
struct BeamCell {
    glm::dvec3 center;     // of its volume
    double size;           // homotheties: of its volume to its object's
    double key;            // where it begins along the rays, never before its parent
    double constant;       // Lipschitz constant of the composed map (not polar)
    double diameter;       // of the cell
    std::uint64_t pixels;  // whose places it may cover
    int set;
    int object;
    int parent;  // -1: an object's outermost cell
    int axes;    // half axes of its volume, in the list; homotheties: -1
    int lane;    // in the parent's set
    std::uint32_t level;
    bool terminal;
    Outline outline;  // unless it is terminal
    bool large;       // several pixels wide
    int first_place;  // of a terminal cell, in the list of what is covered
    int end_place;
};

/// Places of a pixel that a terminal cell covers, a bit each.
struct CoveredPlaces {
    int pixel;
    std::uint32_t places;
};

/// A cell that shows in a pixel, as in dsp_kernels/sight_list.hpp.
struct BeamSight {
    int cell;
    double share;  // of the pixel
    double x, y;   // mean of its places, from the first one, in pixels
};

/// A pixel: its beam, what is left of its places, and what shows in it.
struct PixelBeam {
    LoneRay ray;               // through the first place
    glm::dvec3 across, down;   // unit vectors at right angles to the ray
    double column, row;        // of the first place, from the tile's middle
    double end;                // nothing shows beyond
    std::uint32_t open;        // places that something behind may show at
    std::uint32_t tested = 0;  // cells whose places were looked at
    int sight_count = 0;
    std::array<BeamSight, static_cast<std::size_t>(most_sights)> sights;
    std::array<double, static_cast<std::size_t>(most_places)> left;
    alignas(64) float columns[most_places];  // of the places, from the first one, in the picture
    alignas(64) float rows[most_places];
};

/// From scene units to the tile's picture: X = x . scene point + x0 and so on; a point is seen in
/// column X / S and row Y / S, counted from the tile's middle.
struct TileView {
    glm::dvec3 x, y, s;
    double x0 = 0, y0 = 0, s0 = 0;
    glm::dvec3 along;   // the ray in the middle, a unit vector
    double along0 = 0;  // orthographic: depth = along . point + along0
    bool perspective = true;
    double low_x, high_x;  // columns and rows that places are in, from their pixel's corner
    double low_y, high_y;
};

inline constexpr int beam_scratch_rows = 42;  // of children in lanes

/// No point of a volume is farther from its centre, in X, Y, S, and along the rays.
struct BeamReach {
    double x = 0, y = 0, s = 0, z = 0;
    double any = 0;  // whatever the way
};

/// The levels of the path to a sight: those it has in common with the one before are kept.
struct SightPath {
    static constexpr int capacity = 128;
    static constexpr int inverse = 0;  // 9: scene units to the unit coordinates of the volume
    static constexpr int center = 9;   // 3
    static constexpr int row_count = 12;
    alignas(64) double rows[row_count][capacity + table_step] = {};
    std::array<int, static_cast<std::size_t>(capacity)> cells;
    std::array<float, static_cast<std::size_t>(capacity)> diameters;
    std::array<std::array<float, 3>, static_cast<std::size_t>(capacity)> colors;
    int levels = 0;
    bool spheres = true;  // the volumes; else boxes
};

/// A cell that gives the path of a sight a normal.
struct GivenNormal {
    glm::vec3 normal;  // scene coordinates
    double depth;      // where the ray enters it
    float weight;
};

/// One thread's tools.
struct BeamWorkspace {
    TileView view;
    std::uint64_t open = 0;  // pixels with an open place
    std::array<PixelBeam, static_cast<std::size_t>(packet_rays)> pixels;
    int places = 0;
    std::array<double, static_cast<std::size_t>(most_places)> place_x;  // from the first one, in
    std::array<double, static_cast<std::size_t>(most_places)> place_y;  // pixels
    std::vector<BeamCell> cells;
    std::vector<std::array<double, 9>> axes;
    std::vector<CoveredPlaces> covered;
    std::vector<std::pair<double, int>> queue;  // (key, cell), a heap
    std::vector<BeamReach> reaches;             // of objects of homotheties
    hwy::AlignedFreeUniquePtr<double[]> scratch;
    std::uint64_t tested = 0;
    bool given_up = false;  // too many cells: the reference kernels are to judge
    SightPath path;
    std::vector<EnclosingNormal> enclosing;
    std::vector<GivenNormal> given;  // to the sight that is being looked at
};

/// Makes room for a scene.
void prepare_beams(const WideScene& scene, BeamWorkspace& work);

/// Finds what shows in the pixels of the workspace, on the widest registers there are.
/// Precondition: its view, its pixels and `open` are set.
void search_beams(const WideScene& scene, BeamWorkspace& work);

/// Looks at a cell along a ray.
void see_sight(const WideScene& scene, BeamWorkspace& work, int cell, const LoneRay& ray,
               ShadedHit& seen);

/// The 24-bit hash of a cell's word, as host/engine/gather.hpp has it.
[[nodiscard]] std::uint32_t beam_word(const WideScene& scene, const BeamWorkspace& work, int cell);

}  // namespace pxm::host::wide
