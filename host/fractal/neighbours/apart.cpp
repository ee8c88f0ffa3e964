#include "host/fractal/neighbours/apart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <utility>

namespace pxm::host {

namespace {

using exact::BallEntries;
using exact::RealBall;

constexpr double wider = 2e-6;         // of radii, for bounds of rounded maps, and for rounding
constexpr std::size_t work = 3'000;    // pairs of cells
constexpr std::size_t least_work = 8;  // of a pair of maps

using Middle = std::array<RealBall, 3>;

struct Cell {
    BallEntries map;
    int set = 0;
    Middle center;  // of a ball around it
    double radius = 0;
    Middle middle;  // of a box around it
    glm::dvec3 half{0.0};
};

Middle image(const BallEntries& map, const glm::dvec3& point) {
    Middle place;
    for (std::size_t r = 0; r < 3; ++r) {
        place[r] = map[r][3];
        for (std::size_t c = 0; c < 3; ++c)
            place[r] = place[r] + map[r][c] * RealBall::of_double(point[static_cast<int>(c)], 0);
    }
    return place;
}

/// Above the largest singular value, from the balls' middles: that they are doubles, and the balls'
/// radii, is in the margin.
double stretch(const BallEntries& map) {
    constexpr double rounding = 0x1p-48;  // of sums of three products of rounded numbers
    double squares = 0;
    std::array<std::array<double, 3>, 3> middle{}, most{}, radius{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c) {
            middle[r][c] = map[r][c].middle();
            most[r][c] = map[r][c].most();
            radius[r][c] = map[r][c].radius();
            squares += most[r][c] * most[r][c];
        }
    double largest = 0;  // row sum of A^T A
    for (std::size_t i = 0; i < 3; ++i) {
        double row = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            double sum = 0, off = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                sum += middle[k][i] * middle[k][j];
                off += radius[k][i] * most[k][j] + most[k][i] * radius[k][j] +
                       rounding * most[k][i] * most[k][j];
            }
            row += std::abs(sum) + off;
        }
        largest = std::max(largest, row);
    }
    return std::sqrt(std::min(largest, squares) * (1 + rounding));
}

class ApartSearch {
  public:
    ApartSearch(const exact::BallMaps& balls, const Rifs& rifs, const std::vector<Bounds>& bounds,
                double smallest)
        : balls_(balls), rifs_(rifs), bounds_(bounds), smallest_(smallest) {}

    PairsOfMaps run() {
        std::size_t pairs = 1;
        for (const FollowSet& set : rifs_.follow_sets)
            pairs += set.maps.size() * (set.maps.size() - 1) / 2;
        PairsOfMaps together;
        for (std::size_t s = 0; s < rifs_.follow_sets.size(); ++s) {
            const std::vector<int>& maps = rifs_.follow_sets[s].maps;
            auto& of_set = together.emplace_back();
            std::vector<Cell> cells;
            const bool few = pairs <= work;
            for (std::size_t i = 0; few && i < maps.size(); ++i)
                cells.push_back(cell(balls_.maps[static_cast<std::size_t>(maps[i])],
                                     rifs_.follow_of[static_cast<std::size_t>(maps[i])]));
            for (std::size_t j = 0; j < maps.size(); ++j)
                for (std::size_t i = 0; i < j; ++i) {
                    left_ = std::max(least_work, work / pairs);
                    size_ = bounds_[s].ball.radius;
                    if (!few || !are_apart(cells[i], cells[j]))
                        of_set.push_back({maps[i], maps[j]});
                }
        }
        return together;
    }

  private:
    [[nodiscard]] Cell cell(BallEntries map, int set) const {
        const Bounds& b = bounds_[static_cast<std::size_t>(set)];
        Cell result;
        result.set = set;
        result.center = image(map, b.ball.center);
        result.middle = image(map, (b.box.low + b.box.high) / 2.0);
        result.radius = stretch(map) * b.ball.radius * (1 + wider);
        // The box of the rounded maps is short by no more than the ball.
        const glm::dvec3 half = (b.box.high - b.box.low) / 2.0 + wider * b.ball.radius;
        for (std::size_t r = 0; r < 3; ++r) {
            double sum = 0;
            for (std::size_t c = 0; c < 3; ++c) sum += map[r][c].most() * half[static_cast<int>(c)];
            result.half[static_cast<int>(r)] = sum * (1 + wider);
        }
        result.map = std::move(map);
        return result;
    }

    [[nodiscard]] static bool bounds_are_apart(const Cell& a, const Cell& b) {
        constexpr double rounding = 0x1p-40;
        double squares = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const int axis = static_cast<int>(i);
            const double far = (a.center[i] - b.center[i]).least();
            squares += far * far;
            const double beside = (a.middle[i] - b.middle[i]).least();
            if (beside * (1 - rounding) > (a.half[axis] + b.half[axis]) * (1 + rounding))
                return true;
        }
        return std::sqrt(squares) * (1 - rounding) > (a.radius + b.radius) * (1 + rounding);
    }

    bool are_apart(const Cell& a, const Cell& b) {
        if (bounds_are_apart(a, b)) return true;
        if (left_ == 0 || a.radius + b.radius < smallest_ * size_) return false;
        --left_;
        const Cell& large = a.radius >= b.radius ? a : b;
        const Cell& small = a.radius >= b.radius ? b : a;
        for (const int m : rifs_.follow_sets[static_cast<std::size_t>(large.set)].maps) {
            const auto map = static_cast<std::size_t>(m);
            const Cell part =
                cell(exact::composed(large.map, balls_.maps[map]), rifs_.follow_of[map]);
            if (!are_apart(part, small)) return false;
        }
        return true;
    }

    const exact::BallMaps& balls_;
    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    double smallest_;
    double size_ = 0;
    std::size_t left_ = 0;
};

}  // namespace

PairsOfMaps not_told_apart(const exact::BallMaps& balls, const Rifs& rifs,
                           const std::vector<Bounds>& bounds, double smallest) {
    return ApartSearch(balls, rifs, bounds, smallest).run();
}

}  // namespace pxm::host
