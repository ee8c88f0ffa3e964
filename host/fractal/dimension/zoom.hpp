// A random place of an attractor, and the part of the attractor around it, from one scale to the
// next finer one: how much of a measure the boxes hold that the place lies in.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <random>
#include <vector>

#include "host/fractal/bounds/affine_hull.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/dimension/layers.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// What all places of one system share.
struct ZoomSystem {
    /// `bounds` as from bound().
    ZoomSystem(const Rifs& rifs, const std::vector<Bounds>& bounds);

    const Rifs& rifs;
    std::vector<double> lip;         // per map
    std::vector<double> diameter;    // per follow set: of a ball around E_s
    std::vector<glm::dvec3> center;  // and its centre
    std::vector<glm::dvec3> inner;   // per follow set: a point of E_s
    std::vector<glm::dvec3> seen;    // per map: its image of the centre of what may stand inside
    double rounding = 0;             // that such points may be off by, wherever a cell puts them
    bool similitudes = true;         // the constants of words are the products of the maps'
    std::vector<glm::dvec3> middle;  // per follow set: of a box around E_s
    std::vector<glm::dvec3> half;    // and half its sides
    std::vector<glm::dvec3> seen_middle;  // per map: the same of its image
    std::vector<glm::dvec3> seen_half;
    std::vector<AffineHull> hulls;  // per follow set
    std::optional<Layers> layers;   // of systems that have them: in place of `choice`
    double finest = 0;              // the diameter of cells that are points, of a box's side
    std::vector<std::vector<double>> choice;  // per follow set: the maps' probabilities
};

/// The same numbers from the same seed, on every computer.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}
    /// From 0 to 1, evenly.
    [[nodiscard]] double next() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  private:
    std::mt19937_64 random_;
};

class Zoom {
  public:
    explicit Zoom(const ZoomSystem& system);

    /// To boxes of `side`, which is less than before. The mean, over places of the grid, of one
    /// over the measure of the box that the place lies in; its mean over places is the number of
    /// boxes. Each cell of the attractor that is small against a box counts as one point. Nothing
    /// more can be done if it is 0: there are too many cells. Adds the cells looked at to `visits`.
    [[nodiscard]] double to(double side, Dice& dice, long& visits);

  private:
    struct Cell {
        Affine map;
        int set = 0;
        double size = 1;      // by which the map stretches at most
        double diameter = 0;  // of the cell, at most
        double measure = 1;
    };

    /// The probabilities of the maps inside a cell where cells of `largest` are points.
    [[nodiscard]] const std::vector<double>& choice(const Cell& cell, double largest) const;
    /// Whether the probabilities are the same at all finer scales, or depend on the scale.
    [[nodiscard]] bool is_thick(const Cell& cell, double largest) const;
    [[nodiscard]] Cell drawn(const Cell& cell, double largest, Dice& dice) const;
    [[nodiscard]] Cell child(const Cell& cell, int map, double probability) const;
    /// Below or about how wide a cell is where it is thinnest.
    [[nodiscard]] double thickness(const Cell& cell) const;
    /// Where points of the attractor count.
    struct Window {
        glm::dvec3 middle;
        glm::dvec3 half;  // its sides: all the same for similitudes
    };
    [[nodiscard]] bool is_beside(const Cell& cell, const glm::dvec3& middle, const glm::dvec3& half,
                                 const Window& window) const;
    /// Whether a cell is proven to be outside of the window.
    [[nodiscard]] bool is_away(const Cell& cell, const Window& window) const;
    /// A cell that is kept for the next scale and not divided now.
    [[nodiscard]] bool is_small(const Cell& cell, double largest) const;
    /// The cells around the place, with those that are thin and long divided until they are short.
    /// Cells that look the same in boxes of `side` are one, for now.
    [[nodiscard]] bool divide_thin(double side, double largest, long& visits);
    /// Whether a child is clearly outside, so that it need not be made.
    [[nodiscard]] bool is_away(const Cell& cell, int map, const Window& window) const;
    [[nodiscard]] bool choose_place(double largest, Dice& dice, long& visits);
    [[nodiscard]] bool gather(double side, double largest, long& visits);
    [[nodiscard]] double one_over_measure(double side, Dice& dice) const;

    const ZoomSystem* system_;
    Cell own_;   // the cell that the place is drawn in; of layers, as long as it is thick
    Cell last_;  // the cell that the place is the point of
    glm::dvec3 place_{0.0};
    std::vector<Cell> around_;  // cells that may have points in a box with the place
    std::vector<Cell> short_;   // of affine systems: what these are made of, all of them short
};

}  // namespace pxm::host
