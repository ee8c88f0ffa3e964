#include "host/fractal/neighbours/volume_bracket.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "host/fractal/neighbours/neighbourhoods.hpp"

namespace pxm::host {

namespace {

constexpr double margin = 1e-6;              // of a box's side, for rounding
constexpr std::size_t most_cells = 300'000;  // looked at
constexpr std::size_t most_states = 8'000;   // neighbourhoods of them
constexpr int seed_levels = 1;               // below a cell of the inside

/// A point of each E_s.
std::vector<glm::dvec3> points_of(const Rifs& rifs, const std::vector<Bounds>& bounds) {
    constexpr int rounds = 2'000;
    std::vector<glm::dvec3> points;
    for (const Bounds& b : bounds) points.push_back(b.ball.center);
    for (int round = 0; round < rounds; ++round) {
        std::vector<glm::dvec3> next = points;
        for (std::size_t s = 0; s < points.size(); ++s) {
            const auto m = static_cast<std::size_t>(rifs.follow_sets[s].maps.front());
            next[s] = rifs.maps[m].point(points[static_cast<std::size_t>(rifs.follow_of[m])]);
        }
        if (next == points) break;
        points = std::move(next);
    }
    return points;
}

/// Reached: inside or outside, as far as is known. Free: outside, in the end.
enum class Mark : std::uint8_t { free, boundary, inside, outside, reached };

/// Boxes in up to three coordinates, with one to spare on every side.
class Grid {
  public:
    Grid(const exact::ExactSystem& system, const Box& box, std::size_t boxes_a_side)
        : n_(std::clamp<std::size_t>(static_cast<std::size_t>(system.field.dimensions), 1, 3)),
          axes_(system.axes) {
        double widest = 0;
        for (std::size_t i = 0; i < n_; ++i)
            widest = std::max(widest, box.high[axes_[i]] - box.low[axes_[i]]);
        side_ = widest / static_cast<double>(boxes_a_side);
        std::size_t all = 1;
        for (std::size_t i = 0; i < n_; ++i) {
            constexpr double spare = 2;
            low_[i] = box.low[axes_[i]] - spare * side_;
            count_[i] = static_cast<long>((box.high[axes_[i]] - low_[i]) / side_ + spare) + 1;
            all *= static_cast<std::size_t>(count_[i]);
        }
        marks_.assign(all, Mark::free);
        covers_.assign(all, 0);
    }

    [[nodiscard]] double side() const { return side_; }
    [[nodiscard]] double extent(const glm::dvec3& half) const {
        double widest = 0;
        for (std::size_t i = 0; i < n_; ++i) widest = std::max(widest, 2 * half[axes_[i]]);
        return widest;
    }

    /// All boxes near the box around `center`.
    void mark_boundary(const glm::dvec3& center, const glm::dvec3& half) {
        const auto [low, high] = range(center, half);
        for (long x = low[0]; x <= high[0]; ++x)
            for (long y = low[1]; y <= high[1]; ++y)
                for (long z = low[2]; z <= high[2]; ++z) marks_[number({x, y, z})] = Mark::boundary;
    }

    /// The inside reaches no further than the boxes around such centers: at corners of the range
    /// stands what summing up along each axis makes the number of them that a box lies in.
    void cover(const glm::dvec3& center, const glm::dvec3& half) {
        const auto [low, high] = range(center, half);
        for (unsigned corner = 0; corner < 1U << n_; ++corner) {
            std::array<long, 3> at{};
            bool within = true, minus = false;
            for (std::size_t i = 0; i < n_; ++i) {
                const bool beyond = (corner >> i & 1U) != 0;
                at[i] = beyond ? high[i] + 1 : low[i];
                minus = minus != beyond;
                within = within && at[i] < count_[i];
            }
            if (within) covers_[number(at)] += minus ? -1 : 1;
        }
    }

    /// Leaves out what no cell of the inside reaches. After the seeds of the inside.
    void uncover() {
        std::size_t stride = 1;
        for (std::size_t i = n_; i-- > 0;) {
            const auto count = static_cast<std::size_t>(count_[i]);
            for (std::size_t k = 0; k < covers_.size(); ++k)
                if (k / stride % count > 0) covers_[k] += covers_[k - stride];
            stride *= count;
        }
        // What hangs together is outside if none of it is reached.
        for (std::size_t k = 0; k < marks_.size(); ++k)
            if (marks_[k] == Mark::free && covers_[k] > 0) begin(k, Mark::reached);
    }

    /// A point of the inside, after the boundary.
    void begin_inside(const glm::dvec3& point) {
        std::array<long, 3> at{};
        for (std::size_t i = 0; i < n_; ++i) at[i] = place(i, point[axes_[i]], 0);
        begin(number(at), Mark::inside);
    }
    void begin_outside() { begin(0, Mark::outside); }

    [[nodiscard]] VolumeBracket bracket() const {
        const auto boxes = [&](Mark mark) {
            return static_cast<double>(std::ranges::count(marks_, mark));
        };
        const double one = std::pow(side_, static_cast<double>(n_));
        const double low = boxes(Mark::inside) * one;
        return {low, low + (boxes(Mark::boundary) + boxes(Mark::reached)) * one};
    }

  private:
    using Range = std::pair<std::array<long, 3>, std::array<long, 3>>;
    [[nodiscard]] Range range(const glm::dvec3& center, const glm::dvec3& half) const {
        Range result;
        for (std::size_t i = 0; i < n_; ++i) {
            result.first[i] = place(i, center[axes_[i]] - half[axes_[i]], -margin);
            result.second[i] = place(i, center[axes_[i]] + half[axes_[i]], margin);
        }
        return result;
    }
    [[nodiscard]] long place(std::size_t i, double x, double more) const {
        const auto found = static_cast<long>(std::floor((x - low_[i]) / side_ + more));
        return std::clamp(found, 0L, count_[i] - 1);
    }
    [[nodiscard]] std::size_t number(const std::array<long, 3>& at) const {
        std::size_t result = 0;
        for (std::size_t i = 0; i < n_; ++i)
            result = result * static_cast<std::size_t>(count_[i]) + static_cast<std::size_t>(at[i]);
        return result;
    }

    /// Marks what hangs together with a box by sides.
    void begin(std::size_t box, Mark mark) {
        if (marks_[box] != Mark::free) return;
        std::vector<std::size_t> waiting{box};
        marks_[box] = mark;
        while (!waiting.empty()) {
            std::size_t at = waiting.back();
            waiting.pop_back();
            std::size_t stride = 1, rest = at;
            for (std::size_t i = n_; i-- > 0;) {
                const auto count = static_cast<std::size_t>(count_[i]);
                const std::size_t along = rest % count;
                rest /= count;
                const auto visit = [&](std::size_t next) {
                    if (marks_[next] != Mark::free) return;
                    marks_[next] = mark;
                    waiting.push_back(next);
                };
                if (along > 0) visit(at - stride);
                if (along + 1 < count) visit(at + stride);
                stride *= count;
            }
        }
    }

    std::size_t n_;
    std::array<int, 3> axes_;
    double side_ = 0;
    std::array<double, 3> low_{};
    std::array<long, 3> count_{1, 1, 1};
    std::vector<Mark> marks_;
    std::vector<std::int32_t> covers_;
};

struct Cell {
    Affine map;
    int state = 0;
    int below = 0;  // the inside's: how many levels
};

class Descent {
  public:
    Descent(const NeighbourGraph& graph, const Rifs& rifs, const std::vector<Bounds>& bounds)
        : graph_(graph), rifs_(rifs), bounds_(bounds), points_(points_of(rifs, bounds)) {}

    /// False if there are too many cells.
    bool run(Grid& grid) {
        numbers_.clear();
        all_.clear();
        steps_.clear();
        number_of(all_around(graph_, rifs_.start));
        std::vector<Cell> waiting{Cell{}};
        std::vector<glm::dvec3> seeds;
        std::size_t looked = 0;
        while (!waiting.empty()) {
            if (++looked > most_cells || all_.size() > most_states) return false;
            const Cell cell = waiting.back();
            waiting.pop_back();
            const auto state = static_cast<std::size_t>(cell.state);
            const bool inside = all_[state]->types.empty();
            const auto set = static_cast<std::size_t>(all_[state]->set);
            if (inside) seeds.push_back(cell.map.point(points_[set]));
            if (inside && cell.below >= seed_levels) {
                grid.cover(center_of(cell, set), half_of(cell, set));
                continue;
            }
            if (!inside && small(grid, cell, set)) continue;
            const std::vector<int>& maps = rifs_.follow_sets[set].maps;
            const std::vector<int>& next = steps_of(state);
            for (std::size_t i = 0; i < maps.size(); ++i)
                waiting.push_back({then(rifs_.maps[static_cast<std::size_t>(maps[i])], cell.map),
                                   next[i], inside ? cell.below + 1 : 0});
        }
        grid.begin_outside();
        for (const glm::dvec3& seed : seeds) grid.begin_inside(seed);
        grid.uncover();
        return true;
    }

  private:
    int number_of(const Neighbourhood& one) {
        const auto [place, added] = numbers_.emplace(one, static_cast<int>(all_.size()));
        if (added) all_.push_back(&place->first);
        return place->second;
    }

    const std::vector<int>& steps_of(std::size_t state) {
        if (steps_.size() <= state) steps_.resize(2 * state + 1);
        if (steps_[state].empty())
            for (const Neighbourhood& next : smaller(graph_, rifs_, *all_[state]))
                steps_[state].push_back(number_of(next));
        return steps_[state];
    }

    [[nodiscard]] glm::dvec3 center_of(const Cell& cell, std::size_t set) const {
        return cell.map.point((bounds_[set].box.low + bounds_[set].box.high) / 2.0);
    }

    /// Of the box around the image of the piece's box.
    [[nodiscard]] glm::dvec3 half_of(const Cell& cell, std::size_t set) const {
        const Box& box = bounds_[set].box;
        glm::dvec3 half{0.0};
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                half[i] += std::abs(cell.map.linear[k][i]) * (box.high[k] - box.low[k]) / 2;
        return half;
    }

    /// Marks a cell at the boundary if it is small enough.
    [[nodiscard]] bool small(Grid& grid, const Cell& cell, std::size_t set) const {
        const glm::dvec3 half = half_of(cell, set);
        if (grid.extent(half) > grid.side()) return false;
        grid.mark_boundary(center_of(cell, set), half);
        return true;
    }

    const NeighbourGraph& graph_;
    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    std::vector<glm::dvec3> points_;
    std::map<Neighbourhood, int> numbers_;
    std::vector<const Neighbourhood*> all_;
    std::vector<std::vector<int>> steps_;
};

}  // namespace

std::optional<VolumeBracket> volume_bracket(const exact::ExactSystem& system, const Rifs& rifs,
                                            const NeighbourGraph& graph,
                                            const std::vector<Bounds>& bounds) {
    const int n = system.field.dimensions;
    if (n < 3 && !exact::is_coordinate_plane(system)) return std::nullopt;
    constexpr std::array<std::array<std::size_t, 3>, 3> boxes_a_side{
        {{65'536, 8'192, 512}, {1'024, 256, 64}, {96, 48, 24}}};
    Descent descent(graph, rifs, bounds);
    for (const std::size_t boxes : boxes_a_side[static_cast<std::size_t>(n - 1)]) {
        Grid grid(system, bounds[static_cast<std::size_t>(rifs.start)].box, boxes);
        if (descent.run(grid)) return grid.bracket();
    }
    return std::nullopt;
}

}  // namespace pxm::host
