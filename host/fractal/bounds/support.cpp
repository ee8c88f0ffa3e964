#include "host/fractal/bounds/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>
#include <unordered_map>

#include "host/fractal/bounds/reach_proof.hpp"
#include "host/math/rounding.hpp"
#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

constexpr double direction_grid = 0x1p38;  // directions that agree to this are one
constexpr double rounding = 1e-14;      // of the numbers compared: reaches that agree to this tie
constexpr std::size_t most_rivals = 8;  // cells kept for one set and direction
constexpr long default_budget = 2'000'000;  // cells looked at by support()

/// A word of maps; what it does to the reach in direction u is u . W(x) = offset + direction . x.
struct Cell {
    double upper;
    ReachOfCell reach;
    int set;  // what stands inside
    int parent;
    int map;
    double inner = 0;  // known of the reach in its direction
    bool dominated = false;
};

/// A follow set and a direction without its length.
struct Heading {
    int set;
    std::array<std::int64_t, 3> direction;
    bool operator==(const Heading&) const = default;
};

struct HeadingHash {
    std::size_t operator()(const Heading& heading) const {
        auto value = static_cast<std::uint64_t>(heading.set) + 0x9e3779b97f4a7c15;
        for (const std::int64_t part : heading.direction) {
            value = (value ^ static_cast<std::uint64_t>(part)) * 0xff51afd7ed558ccd;
            value ^= value >> 32;
        }
        return value;
    }
};

class ReachSearch {
  public:
    ReachSearch(const Rifs& rifs, const Approximation& known, double tolerance)
        : rifs_(rifs), known_(known), tolerance_(tolerance) {}

    Reach search(int set, const glm::dvec3& u, long budget) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        add({infinity, {0, u, 0, infinity}, set, -1, -1});
        while (!queue_.empty() && queue_.top().first > lower_ + tolerance_ && looked_at_ < budget) {
            give_up_if_asked();
            const int next = queue_.top().second;
            queue_.pop();
            if (cells_[next].dominated) continue;
            looked_at_ += expand(next);
        }
        double upper = std::max(lower_, upper_of_dropped_);
        if (!queue_.empty()) upper = std::max(upper, queue_.top().first);
        const double sure = proof_.at_most(upper);
        return {upper, sure <= upper ? 0 : above(sure - upper), lower_, best_point(), looked_at_};
    }

  private:
    struct Rival {
        int cell;
        double offset;
        double scale;
    };

    long expand(int index) {
        const Cell cell = cells_[index];
        const std::vector<int>& maps = rifs_.follow_sets[cell.set].maps;
        proof_.expand(index);
        for (const int m : maps) {
            add({cell.upper, inside(cell.reach, m), rifs_.follow_of[m], index, m});
        }
        return static_cast<long>(maps.size());
    }

    /// The reach in a cell of what stands in one more map. For every point of it the equation is
    /// off by what it was off by before, and by the rounding of this step.
    [[nodiscard]] ReachOfCell inside(const ReachOfCell& cell, int m) const {
        const auto& [linear, translation] = rifs_.maps[m];
        ReachOfCell result{cell.offset + glm::dot(cell.direction, translation),
                           cell.direction * linear, cell.error, cell.sure};
        const glm::dvec3 places =
            terms_of(linear, coordinates(known_, rifs_.follow_of[m]), translation);
        result.error += rounding_of(std::abs(cell.offset) + std::abs(result.offset) +
                                    dot_of_parts(cell.direction, places));
        return result;
    }

    /// Takes a cell in unless it cannot reach farther than what is known. Its `upper` is its
    /// parent's.
    void add(Cell cell) {
        const double offset = cell.reach.offset;
        const glm::dvec3& direction = cell.reach.direction;
        const Rounded of_volumes = volume_support(known_, cell.set, direction);
        const double outer = of_volumes.value;
        const glm::dvec3& point = extreme(known_.inner[cell.set], direction);
        const double inner = glm::dot(point, direction);
        cell.upper = std::min(cell.upper, offset + outer);
        cell.reach.limit_to(of_volumes);
        const bool farther = offset + inner > lower_;
        if (!farther && cell.upper <= lower_ + tolerance_) {
            upper_of_dropped_ = std::max(upper_of_dropped_, cell.upper);
            proof_.close(cell.parent, cell.reach.sure);
            return;
        }
        if (farther) {
            lower_ = offset + inner;
            best_ = static_cast<int>(cells_.size());
            best_inner_ = point;
        }
        const int ahead = find_ahead(cell, inner, outer);
        if (ahead >= 0 && !farther) {
            proof_.drop(cell.parent, cell.reach.sure, yield_of(cell, cells_[ahead], ahead));
            return;
        }
        queue_.emplace(cell.upper, static_cast<int>(cells_.size()));
        proof_.add(cell.parent, cell.reach.sure);
        cells_.push_back(cell);
    }

    [[nodiscard]] Yield yield_of(const Cell& cell, const Cell& to, int index) const {
        return yield(cell.reach, to.reach, index, coordinates(known_, cell.set));
    }

    /// Compares a cell with others of its heading: cells reach offset + scale h for one unknown h
    /// between `inner` and `outer` over the scale, so one that is ahead at both ends is ahead. The
    /// number of one that is; else -1, and those that this one is ahead of are left out.
    int find_ahead(const Cell& cell, double inner, double outer) {
        const double scale = glm::length(cell.reach.direction);
        if (!(scale > std::numeric_limits<double>::min())) return -1;
        const double offset = cell.reach.offset;
        std::vector<Rival>& rivals = rivals_[heading(cell, scale)];
        const double slack = rounding * (std::abs(offset) + std::abs(outer) + std::abs(inner));
        const auto ahead = [&](const Rival& a, const Rival& b, double allowed) {
            const double low = a.offset - b.offset + (a.scale - b.scale) * (inner / scale);
            const double high = a.offset - b.offset + (a.scale - b.scale) * (outer / scale);
            return std::min(low, high) >= -allowed;
        };
        const Rival self{static_cast<int>(cells_.size()), offset, scale};
        for (const Rival& rival : rivals) {
            if (ahead(rival, self, slack)) return rival.cell;
        }
        std::erase_if(rivals, [&](const Rival& rival) {
            if (!ahead(self, rival, 0)) return false;
            Cell& behind = cells_[rival.cell];
            behind.dominated = true;
            proof_.leave_out(rival.cell, yield_of(behind, cell, self.cell));
            return true;
        });
        if (rivals.size() < most_rivals) rivals.push_back(self);
        return -1;
    }

    static Heading heading(const Cell& cell, double scale) {
        Heading result{cell.set, {}};
        for (int i = 0; i < 3; ++i) {
            result.direction[i] = std::llround(cell.reach.direction[i] / scale * direction_grid);
        }
        return result;
    }

    [[nodiscard]] glm::dvec3 best_point() const {
        glm::dvec3 point = best_inner_;
        for (int cell = best_; cell >= 0; cell = cells_[cell].parent) {
            if (cells_[cell].map >= 0) point = rifs_.maps[cells_[cell].map].point(point);
        }
        return point;
    }

    const Rifs& rifs_;
    const Approximation& known_;
    double tolerance_;
    std::vector<Cell> cells_;
    ReachProof proof_;
    std::priority_queue<std::pair<double, int>> queue_;
    std::unordered_map<Heading, std::vector<Rival>, HeadingHash> rivals_;
    double lower_ = -std::numeric_limits<double>::infinity();
    double upper_of_dropped_ = -std::numeric_limits<double>::infinity();
    int best_ = -1;
    glm::dvec3 best_inner_{0.0};
    long looked_at_ = 0;
};

}  // namespace

Reach reach(const Rifs& rifs, const Approximation& known, int set, const glm::dvec3& u,
            double tolerance, long budget) {
    return ReachSearch(rifs, known, tolerance).search(set, u, budget);
}

double support(const Rifs& rifs, const std::vector<Bounds>& bounds, int set, const glm::dvec3& u,
               double tolerance) {
    return reach(rifs, approximation(rifs, bounds), set, u, tolerance, default_budget).at_most();
}

}  // namespace pxm::host
