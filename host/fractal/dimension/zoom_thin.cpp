// Cells of affine systems that are long against a box and thin against it: there are more of them
// than can be looked at, but few that a box could tell apart.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <utility>
#include <vector>

#include "host/fractal/dimension/zoom.hpp"

namespace pxm::host {

namespace {

constexpr double alike = 0.25;  // of a point's size: cells that differ by it are one
constexpr std::size_t most_short = 5000;
constexpr long most_divided = 400'000;  // of one step

/// What a cell looks like, in units of what does not matter.
struct Looks {
    std::array<std::int64_t, 13> numbers{};
    bool operator==(const Looks&) const = default;
    [[nodiscard]] std::size_t hash() const {
        std::size_t sum = 0;
        for (const std::int64_t n : numbers) {
            sum = (sum ^ static_cast<std::size_t>(n)) * 0x9e3779b97f4a7c15U;
            sum ^= sum >> 29U;
        }
        return sum;
    }
};

/// Numbers looks from 0 on. One table for all: a map's memory would cost more than its search.
class KnownLooks {
  public:
    /// Which one it is, and whether it is new.
    std::pair<std::size_t, bool> number(const Looks& looks) {
        if (2 * (known_.size() + 1) > places_.size()) grow();
        std::size_t place = looks.hash() & (places_.size() - 1);
        for (; places_[place] != 0; place = (place + 1) & (places_.size() - 1))
            if (known_[places_[place] - 1] == looks) return {places_[place] - 1, false};
        known_.push_back(looks);
        places_[place] = static_cast<std::uint32_t>(known_.size());
        return {known_.size() - 1, true};
    }
    void clear() {
        known_.clear();
        std::ranges::fill(places_, 0U);
    }

  private:
    void grow() {
        constexpr std::size_t fewest = 64;
        places_.assign(std::max(fewest, 2 * places_.size()), 0);
        for (std::size_t i = 0; i < known_.size(); ++i) {
            std::size_t place = known_[i].hash() & (places_.size() - 1);
            while (places_[place] != 0) place = (place + 1) & (places_.size() - 1);
            places_[place] = static_cast<std::uint32_t>(i + 1);
        }
    }

    std::vector<Looks> known_;
    std::vector<std::uint32_t> places_;  // 1 more than the number; 0: none
};

/// Of a cell around `center`, in units of what does not matter, whose box has half these sides.
Looks looks_of(const Affine& map, const glm::dvec3& center, const glm::dvec3& half, double unit) {
    Looks looks;
    std::size_t n = 0;
    const auto add = [&](const glm::dvec3& x) {
        for (int i = 0; i < 3; ++i)
            looks.numbers[n++] = static_cast<std::int64_t>(std::floor(x[i] / unit + 0.5));
    };
    add(center);
    for (int i = 0; i < 3; ++i) add(map.linear[i] * half[i]);
    return looks;
}

}  // namespace

bool Zoom::divide_thin(double side, double largest, long& visits) {
    const ZoomSystem& system = *system_;
    const double unit = largest * alike;
    const Window window{place_, glm::dvec3{side + largest}};
    short_.clear();
    std::vector<Cell> open;
    for (const Cell& cell : around_)
        if (!is_away(cell, window)) open.push_back(cell);
    long left = most_divided;
    KnownLooks known;
    std::vector<Cell> next;
    while (!open.empty()) {  // level by level: cells that look the same are of one level
        next.clear();
        known.clear();
        for (const Cell& cell : open) {
            if (cell.diameter <= largest) {
                if (short_.size() >= most_short) return false;
                short_.push_back(cell);
                continue;
            }
            const std::vector<int>& maps = system.rifs.follow_sets[cell.set].maps;
            const std::vector<double>& shares = choice(cell, largest);
            visits += static_cast<long>(maps.size());
            left -= static_cast<long>(maps.size());
            if (left < 0) return false;
            for (std::size_t i = 0; i < maps.size(); ++i) {
                if (is_away(cell, maps[i], window)) continue;
                const Cell part = child(cell, maps[i], shares[i]);
                const auto set = static_cast<std::size_t>(part.set);
                Looks looks = looks_of(part.map, part.map.point(system.center[set]) - place_,
                                       system.half[set], unit);
                looks.numbers.back() = part.set;
                const auto [at, added] = known.number(looks);
                if (added) {
                    next.push_back(part);
                } else {
                    next[at].measure += part.measure;
                }
            }
        }
        std::swap(open, next);
    }
    // The place's own cell may have been taken for one that looks the same: its point is the place.
    double nearest = INFINITY;
    const glm::dvec3 place = place_;
    for (const Cell& cell : short_) {
        const glm::dvec3 point = cell.map.point(system.inner[cell.set]);
        const glm::dvec3 off = glm::abs(point - place);
        const double away = std::max({off.x, off.y, off.z});
        if (away >= nearest) continue;
        nearest = away;
        place_ = point;
    }
    return true;
}

}  // namespace pxm::host
