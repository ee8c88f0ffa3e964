// What a search for a reach has proven, rounding or not. The search (support.hpp) leaves out cells
// that others of their heading are ahead of, as far as double can tell; some of those are the cells
// that hold the ones left out. Whether that was right is decided here, from what each cell is off
// by.
#pragma once

#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "host/math/rounding.hpp"

namespace pxm::host {

/// A word W of maps, seen in a direction u: u . W(x) is offset + direction . x for all x that may
/// stand inside, up to `error`; and `sure` is not exceeded.
struct ReachOfCell {
    double offset = 0;
    glm::dvec3 direction{0.0};
    double error = 0;
    double sure = std::numeric_limits<double>::infinity();

    /// What stands inside reaches no farther than `outer` in the cell's direction.
    void limit_to(const Rounded& outer);
};

/// A cell's reach is at most shift + slope times that of another, slope <= 1.
struct Yield {
    int to = -1;
    double slope = 1;
    double shift = 0;
    double error = 0;  // part of the shift: what is no more than rounding
};

/// How the reach of cell `a` hangs on that of `b`, number `to`, in which the same set stands: no
/// point of it has coordinates beyond `places`.
[[nodiscard]] Yield yield(const ReachOfCell& a, const ReachOfCell& b, int to,
                          const glm::dvec3& places);

class ReachProof {
  public:
    /// Of a cell that was taken in: its number is how many there were before. The first is all
    /// there is, and its parent is -1.
    void add(int parent, double sure);
    /// All cells inside it are added, closed or dropped after that.
    void expand(int cell);
    /// Of a cell that was not taken in, for it does not reach far enough.
    void close(int parent, double sure);
    /// ... or for another cell.
    void drop(int parent, double sure, const Yield& yield);
    /// Of a cell that was taken in and is to be left out after all.
    void leave_out(int cell, const Yield& yield);

    /// No smaller than the reach. `about`: what the search takes it to be.
    [[nodiscard]] double at_most(double about) const;

  private:
    struct Cell {
        int parent;
        double sure;
        double sure_inside = -std::numeric_limits<double>::infinity();  // of cells closed in it
        bool expanded = false;
        int last_dropped = -1;  // of the cells dropped in it
        int left_out = -1;
    };
    struct Dropped {
        int before;  // the one dropped before in the same cell
        double sure;
        Yield yield;
    };

    [[nodiscard]] double farthest_leaf() const;
    [[nodiscard]] bool holds(double claim) const;
    void sweep(double claim, std::vector<double>& short_of) const;

    std::vector<Cell> cells_;
    std::vector<Dropped> dropped_;
    std::vector<Yield> left_out_;
    double largest_error_ = 0;
};

}  // namespace pxm::host
