// The definition of the picture (docs/design.md, decision 4) as a program of its own, in double: no
// heap, no order, no re-basing. Every cell that a ray meets is visited; a cell's map is composed
// forward along its word and inverted as a whole; the terminal cells are sorted at the end. It
// takes the compiled scene and shares nothing else with the kernels that it judges.
#pragma once

#include <Eigen/Core>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "host/compiled/compiled_scene.hpp"

namespace pxm::test {

/// A line of sight in scene units; the direction is a unit vector.
struct Sight {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, 1.0};
};

/// A terminal cell that a ray meets, with the ray's interval in it.
struct TerminalCell {
    double key = 0;
    int object = 0;
    std::vector<int> word;  // numbers of the maps from 0, outermost first
    double exit = 0;
    double diameter = 0;
};

/// The order of the definition: (key, object, word).
[[nodiscard]] bool comes_before(const TerminalCell& a, const TerminalCell& b);

/// What is seen at a terminal cell.
struct Appearance {
    glm::dvec3 normal{0.0};  // the total normal, Eq. 17.3
    glm::dvec3 color{0.0};   // Eq. 17.1
};

class Oracle {
  public:
    static constexpr long usual_patience = 20'000'000;  // cells met by one ray

    /// p never falls below `smallest_share` of an object's diameter.
    Oracle(const host::CompiledScene& scene, double smallest_share, long patience = usual_patience);

    /// The line of sight through the centre of a pixel.
    [[nodiscard]] Sight sight(long x, long y) const;
    /// The same so many pixels to the right and down.
    [[nodiscard]] Sight sight(long x, long y, const glm::dvec2& moved) const;
    /// All terminal cells that the ray meets, in order; the first one is what is shown. Throws
    /// std::runtime_error if the ray meets more cells than a test can wait for.
    [[nodiscard]] std::vector<TerminalCell> look(const Sight& ray);
    /// The same without those that lie more than two p behind the first one: all that can be shown.
    /// A cell's key is never smaller than that of the cell around it, so that what begins farther
    /// away need not be opened.
    [[nodiscard]] std::vector<TerminalCell> look_near(const Sight& ray);
    /// p(key) for an object.
    [[nodiscard]] double pixel_size(int object, double key) const;
    /// Shading by the definition (Ch. 17).
    [[nodiscard]] Appearance appearance(const Sight& ray, const TerminalCell& cell) const;

  private:
    /// A cell of the hierarchy, made when a ray first opens the cell it lies in.
    struct Cell {
        host::Affine place;        // cell to scene units
        Eigen::Matrix3d back;      // inverse of its linear part, for row vectors
        double product = 0;        // of the maps' largest singular values, Eq. 16.1
        double diameter = 0;       // by the shape's method
        int set = 0;               // its volume, and what may stand inside
        std::size_t children = 0;  // index of the first; 0: not made yet
    };

    /// The normal of a volume on the path from the outermost cell to the terminal one.
    struct PathNormal {
        std::size_t level;
        glm::dvec3 normal;
        double diameter;
        double t;  // where the ray meets the volume
    };

    /// The normals of cells around an object whose cells became objects of their own.
    [[nodiscard]] std::vector<PathNormal> enclosing_normals(const Sight& ray, int object) const;
    [[nodiscard]] double outermost_size(int object) const;
    [[nodiscard]] std::vector<PathNormal> normals_on_path(const Sight& ray,
                                                          const TerminalCell& seen) const;
    /// The weight of a cell of that diameter on the path (Eqs. 17.4 to 17.6).
    [[nodiscard]] double weight(const TerminalCell& seen, double diameter) const;
    [[nodiscard]] glm::dvec3 total_normal(const TerminalCell& seen,
                                          const std::vector<PathNormal>& path) const;
    [[nodiscard]] double facing_point_light(const Sight& ray, const TerminalCell& seen,
                                            const std::vector<PathNormal>& path,
                                            const glm::dvec3& place) const;
    [[nodiscard]] glm::dvec3 surface_color(const TerminalCell& seen) const;
    [[nodiscard]] const host::CompiledShape& shape_of(int object) const;
    [[nodiscard]] Cell make_cell(int object, const host::Affine& place, double product,
                                 int set) const;
    [[nodiscard]] Cell outermost(int object) const;
    [[nodiscard]] Cell inside(int object, const Cell& cell, int map) const;
    void open(int object, std::size_t cell);
    /// Forgets the cells inside the outermost ones once they are many.
    void forget_cells();
    [[nodiscard]] std::vector<TerminalCell> cells_before(const Sight& ray, double behind);
    void visit(const Sight& ray, std::size_t cell, TerminalCell& path,
               std::vector<TerminalCell>& found);

    const host::CompiledScene& scene_;
    double smallest_share_;
    std::vector<Cell> cells_;           // the objects' outermost cells first
    std::vector<double> object_sizes_;  // diameter of the outermost volume by the exact constant
    std::vector<std::vector<double>> map_lips_;  // per shape and map: Lip w
    long patience_;
    long visited_ = 0;           // cells met by the current ray
    double behind_ = 0;          // how many p behind the nearest cell is still of interest
    double nothing_beyond_ = 0;  // keys from which on nothing is
};

}  // namespace pxm::test
