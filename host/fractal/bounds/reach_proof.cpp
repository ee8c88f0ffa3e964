#include "host/fractal/bounds/reach_proof.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace pxm::host {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int sweeps = 16;     // of a claim; most need one
constexpr int claims = 40;     // tried one after the other
constexpr double farther = 4;  // a claim's room against that of the one before

/// `H - shift - slope (H - gap)` for any H that is no smaller than the claim, H - gap what another
/// cell reaches: so much the cell's own reach is short of H.
double short_by(const Yield& yield, double claim, double gap) {
    const double short_of = (1 - yield.slope) * claim - yield.shift + yield.slope * gap;
    return short_of - rounding_of(std::abs(claim) + std::abs(yield.shift) + gap);
}

}  // namespace

void ReachOfCell::limit_to(const Rounded& outer) {
    const double terms = std::abs(offset) + std::abs(outer.value);
    const double reach = above(offset + outer.value + error + outer.rounding + rounding_of(terms));
    if (reach < sure) sure = reach;
}

// With F the cells' reaches: F_a <= o_a + max d_a . x + e_a and F_b >= o_b + max d_b . x - e_b.
Yield yield(const ReachOfCell& a, const ReachOfCell& b, int to, const glm::dvec3& places) {
    const double scale_a = glm::length(a.direction);
    const double scale_b = glm::length(b.direction);
    const double terms = std::abs(a.offset) + std::abs(b.offset) +
                         dot_of_parts(glm::abs(a.direction) + glm::abs(b.direction), places);
    const double errors = a.error + b.error + 2 * rounding_of(terms);
    if (scale_a <= scale_b) {
        // d_a = slope d_b + rest: F_a <= o_a + slope (F_b - o_b) + |rest| . places.
        const double slope = scale_a / scale_b;
        const glm::dvec3 rest = a.direction - slope * b.direction;
        return {to, slope, a.offset - slope * b.offset + dot_of_parts(rest, places) + errors,
                errors};
    }
    // d_a = d_b + (1 - part) d_a + rest, and d_a . x <= F_a - o_a + e_a.
    const double part = scale_b / scale_a;
    const glm::dvec3 rest = part * a.direction - b.direction;
    const double inside = (1 - part) * (a.sure - a.offset + a.error);
    const double shift = a.offset - b.offset + inside + dot_of_parts(rest, places) + errors;
    return {to, 1, shift + rounding_of(std::abs(a.sure)), errors};
}

void ReachProof::add(int parent, double sure) { cells_.push_back({parent, sure}); }

void ReachProof::expand(int cell) { cells_[static_cast<std::size_t>(cell)].expanded = true; }

void ReachProof::close(int parent, double sure) {
    if (parent < 0) return add(parent, sure);
    double& all = cells_[static_cast<std::size_t>(parent)].sure_inside;
    all = sure > all || !(sure == sure) ? sure : all;
}

void ReachProof::drop(int parent, double sure, const Yield& yield) {
    int& last = cells_[static_cast<std::size_t>(parent)].last_dropped;
    dropped_.push_back({last, sure, yield});
    last = static_cast<int>(dropped_.size()) - 1;
    largest_error_ = std::max(largest_error_, yield.error);
}

void ReachProof::leave_out(int cell, const Yield& yield) {
    cells_[static_cast<std::size_t>(cell)].left_out = static_cast<int>(left_out_.size());
    left_out_.push_back(yield);
    largest_error_ = std::max(largest_error_, yield.error);
}

double ReachProof::farthest_leaf() const {
    double farthest = -infinity;
    for (const Cell& cell : cells_) {
        const bool leaf = !cell.expanded && cell.left_out < 0;
        farthest = std::max({farthest, cell.sure_inside, leaf ? cell.sure : -infinity});
    }
    return farthest;
}

// What is left out cannot simply be taken to reach no farther than what it was left out for: that
// may hold it. But let H be the reach, and suppose that it is more than some claim. Every cell
// reaches at most H, and one that reaches at most shift + slope times another at most
// H - ((1 - slope) claim - shift) for it, for slope <= 1. If it follows from such inequalities,
// each taken for what it is worth, that all there is reaches less than H, the claim is right.
double ReachProof::at_most(double about) const {
    const double all = cells_.front().sure;
    const double leaf = farthest_leaf();
    if (dropped_.empty() && left_out_.empty()) return std::min(all, leaf);
    const double least = std::max(leaf, about);
    double room = 8 * rounding_of(std::abs(least)) + 2 * largest_error_;
    for (int i = 0; i < claims && least + room < all; ++i) {
        if (holds(above(least + room))) return above(least + room);
        room *= farther;
    }
    return all;
}

bool ReachProof::holds(double claim) const {
    std::vector<double> short_of;
    for (const Cell& cell : cells_) short_of.push_back(std::max(below(claim - cell.sure), 0.0));
    for (int i = 0; i < sweeps; ++i) {
        const std::vector<double> before = short_of;
        sweep(claim, short_of);
        if (short_of.front() > 0) return true;
        if (short_of == before) return false;
    }
    return false;
}

/// Makes what the cells are known to be short of H by more, where others tell so. What is inside a
/// cell has a higher number, as most of what it was left out for.
void ReachProof::sweep(double claim, std::vector<double>& short_of) const {
    const auto of_other = [&](const Yield& yield) {
        return short_by(yield, claim, short_of[static_cast<std::size_t>(yield.to)]);
    };
    std::vector<double> inside(cells_.size(), infinity);  // the least of what is inside a cell
    for (std::size_t i = cells_.size(); i-- > 0;) {
        const Cell& cell = cells_[i];
        double& own = short_of[i];
        if (cell.left_out >= 0) {
            own = std::max(own, of_other(left_out_[static_cast<std::size_t>(cell.left_out)]));
        }
        if (cell.expanded) {
            double least = std::min(inside[i], below(claim - cell.sure_inside));
            for (int k = cell.last_dropped; k >= 0;) {
                const Dropped& dropped = dropped_[static_cast<std::size_t>(k)];
                least =
                    std::min(least, std::max(below(claim - dropped.sure), of_other(dropped.yield)));
                k = dropped.before;
            }
            own = std::max(own, least);
        }
        if (cell.parent < 0) continue;
        double& of_parent = inside[static_cast<std::size_t>(cell.parent)];
        of_parent = std::min(of_parent, own);
    }
}

}  // namespace pxm::host
