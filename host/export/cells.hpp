// The cells of a scene's objects, one after another, in the order of their words: what is exported.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/export/mesh.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/math/affine.hpp"

namespace pxm::host {

/// Where cells end: at a level, or as soon as they are no longer than a length in the scene.
struct CellLimit {
    std::optional<long> levels;
    std::optional<double> length;
};

/// An object with what stands for its cells: one mesh for each follow set, in the coordinates of
/// the ifs block. An object without an ifs is one cell.
struct ExportedObject {
    std::string name;
    Rifs rifs;                       // no maps: one cell
    std::vector<Mesh> meshes;        // by follow set
    std::vector<double> diameters;   // of the volumes, by follow set
    std::vector<glm::dvec4> colors;  // of the maps: r, g, b and how much of it
    glm::dvec3 color{0.0};           // of the object, linear
    Affine instance;
    std::optional<long> levels;         // the object's own limit
    std::vector<std::uint64_t> counts;  // of cells, by follow set
    bool sheared = false;  // a cell's axes are not perpendicular: it is not just moved, turned and
                           // scaled along its own axes

    [[nodiscard]] std::uint64_t cells() const;
};

struct Cell {
    Affine place;  // from the coordinates of the ifs block to the scene's
    int set = 0;
    glm::dvec3 color{0.0};  // linear
};

/// Goes through the cells of an object with a stack as high as its words are long.
class CellWalk {
  public:
    CellWalk(const ExportedObject& object, const CellLimit& limit);
    /// The next cell; nothing after the last.
    [[nodiscard]] const Cell* next();

  private:
    struct Step {
        Cell cell;
        std::size_t child = 0;  // the next map to go into, by its place in the follow set
    };
    [[nodiscard]] bool is_last(const Step& step) const;

    const ExportedObject& object_;
    CellLimit limit_;
    std::vector<Step> stack_;
    Cell taken_;
};

/// Counts the cells of an object and looks whether they are sheared. False if there are more than
/// `most`, or if a signal came.
[[nodiscard]] bool count_cells(ExportedObject& object, const CellLimit& limit, std::uint64_t most);

/// How many cells `levels` maps deep there are, without going through them.
[[nodiscard]] double cells_at(const Rifs& rifs, long levels);

}  // namespace pxm::host
