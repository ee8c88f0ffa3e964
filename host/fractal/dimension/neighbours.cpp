#include "host/fractal/dimension/neighbours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_neighbours = 10'000;
constexpr double same = 1e-9;  // of the size: maps that differ by less are one
constexpr double largest_error = same / 4;
constexpr double apart = 1e-9;  // of the size: a gap this wide is one
constexpr double unit_error = 1e-15;
constexpr double rounded = 16;  // times the error of a map: what differs by less is taken for equal
constexpr double largest_map = 1e6;  // Lipschitz constant of a neighbour

/// Piece `inside` of the set `to` as it lies against a piece of the set `from`.
struct Neighbour {
    int from = 0;
    int to = 0;
    Affine map;
    double stretch = 1;  // Lipschitz constant of the map
    double error = 0;    // of the map, about
    int parent = -1;     // the neighbour it was found from, or none: its words have one map each
    int letter = 0;      // the map by which one word is longer than the parent's
    bool inner = true;   // whether that is the second word
};

using Key = std::array<std::int64_t, 14>;

class Search {
  public:
    Search(const Rifs& rifs, const std::vector<Bounds>& bounds) : rifs_(rifs), bounds_(bounds) {
        double far = 0;
        for (const Bounds& b : bounds) {
            size_ = std::max(size_, b.ball.radius);
            far = std::max(far, glm::length(b.ball.center));
        }
        unit_ = unit_error * std::max(far / size_, 1.0);
    }

    NeighbourFinding run() {
        if (!invert()) return {};
        bool complete = begin();
        for (std::size_t i = 0; complete && i < found_.size(); ++i) {
            complete = extend(static_cast<int>(i));
        }
        NeighbourFinding finding;
        if (nearest_) finding = words_of(*nearest_);
        finding.complete = complete;
        if (complete) add_touching(finding);
        if (complete && !nearest_) {
            finding.kind = finding.count > 0 ? Neighbours::finite : Neighbours::apart;
        }
        return finding;
    }

  private:
    bool invert() {
        for (const Affine& map : rifs_.maps) {
            const MapKind kind = classify(map);
            if (kind == MapKind::singular) return false;
            similitudes_ = similitudes_ && kind != MapKind::affine;
            inverse_.push_back(inverse(map));
            stretch_.push_back(lipschitz_constant(map));
            inverse_stretch_.push_back(lipschitz_constant(inverse_.back()));
        }
        return true;
    }

    bool begin() {
        for (const FollowSet& set : rifs_.follow_sets) {
            for (std::size_t i = 0; i < set.maps.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    const int a = set.maps[j];
                    const int b = set.maps[i];
                    Neighbour next{rifs_.follow_of[a], rifs_.follow_of[b],
                                   then(rifs_.maps[b], inverse_[a])};
                    next.stretch = stretch_of(next.map, stretch_[b] * inverse_stretch_[a]);
                    next.error = unit_ * inverse_stretch_[a];
                    next.letter = static_cast<int>(first_words_.size());
                    first_words_.push_back({a, b});
                    if (!add(next, -1)) return false;
                }
            }
        }
        return true;
    }

    /// `product`: of the constants that it was made of, which is right for similitudes.
    [[nodiscard]] double stretch_of(const Affine& map, double product) const {
        return similitudes_ ? product : lipschitz_constant(map);
    }

    [[nodiscard]] bool are_apart(const Neighbour& n) const {
        const Ball& own = bounds_[n.from].ball;
        const Ball& other = bounds_[n.to].ball;
        const double reach = own.radius + n.stretch * other.radius;
        return glm::distance(own.center, n.map.point(other.center)) > reach + apart * size_;
    }

    /// How far a point of the ball is moved at most, over the size: what a map does far from the
    /// set, as to the origin, is nothing to it.
    [[nodiscard]] double from_identity(const Neighbour& n) const {
        const Ball& ball = bounds_[n.from].ball;
        double squares = 0;
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 row = n.map.linear[i];
            row[i] -= 1;
            squares += glm::dot(row, row);
        }
        const double moved = glm::distance(n.map.point(ball.center), ball.center);
        return (moved + std::sqrt(squares) * ball.radius) / size_;
    }

    void compare_with_identity(const Neighbour& n) {
        if (n.from != n.to) return;
        const double difference = from_identity(n);
        if (!(difference < same) || (nearest_ && difference >= difference_)) return;
        nearest_ = static_cast<int>(found_.size());
        difference_ = difference;
    }

    [[nodiscard]] Key key_of(const Neighbour& n) const {
        constexpr double digits = 1 / same;
        const glm::dvec3 place =
            n.map.point(bounds_[n.to].ball.center) - bounds_[n.from].ball.center;
        Key key{n.from, n.to};
        std::size_t k = 2;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) key[k++] = std::llround(n.map.linear[i][j] * digits);
            key[k++] = std::llround(place[i] / size_ * digits);
        }
        return key;
    }

    /// False if the search is over without an answer.
    bool add(const Neighbour& next, int parent) {
        if (are_apart(next)) return true;
        if (!(next.error < largest_error) || !(next.stretch < largest_map)) {
            return false;
        }
        const auto [known, fresh] = index_.emplace(key_of(next), static_cast<int>(found_.size()));
        if (parent >= 0) {
            leads_to_[parent].push_back(known->second);
        } else {
            begins_.push_back({next.letter, known->second});
        }
        if (!fresh) return true;
        if (found_.size() >= most_neighbours) return false;
        compare_with_identity(next);
        found_.push_back(next);
        leads_to_.emplace_back();
        return true;
    }

    /// The larger of the two pieces is cut up.
    bool extend(int index) {
        const Neighbour n = found_[index];
        const double own = bounds_[n.from].ball.radius;
        const double other = n.stretch * bounds_[n.to].ball.radius;
        const bool inner = other > own * (1 + same);
        for (const int m : rifs_.follow_sets[inner ? n.to : n.from].maps) {
            Neighbour next = n;
            next.parent = index;
            next.letter = m;
            next.inner = inner;
            next.map = inner ? then(rifs_.maps[m], n.map) : then(n.map, inverse_[m]);
            next.stretch =
                stretch_of(next.map, n.stretch * (inner ? stretch_[m] : inverse_stretch_[m]));
            next.error = (n.error + unit_) * (inner ? 1 : std::max(1.0, inverse_stretch_[m]));
            (inner ? next.to : next.from) = rifs_.follow_of[m];
            if (!add(next, index)) return false;
        }
        return true;
    }

    /// Pieces that keep apart at last lead to nothing.
    void add_touching(NeighbourFinding& finding) const {
        std::vector<std::vector<int>> led_from(found_.size());
        std::vector<int> left(found_.size());
        std::vector<int> ends;
        for (std::size_t i = 0; i < found_.size(); ++i) {
            left[i] = static_cast<int>(leads_to_[i].size());
            if (left[i] == 0) ends.push_back(static_cast<int>(i));
            for (const int to : leads_to_[i]) led_from[to].push_back(static_cast<int>(i));
        }
        std::vector<char> gone(found_.size(), 0);
        finding.count = found_.size();
        while (!ends.empty()) {
            const int i = ends.back();
            ends.pop_back();
            gone[i] = 1;
            --finding.count;
            for (const int from : led_from[i]) {
                if (--left[from] == 0) ends.push_back(from);
            }
        }
        for (const auto& [words, neighbour] : begins_) {
            if (!gone[neighbour]) finding.touching.push_back(first_words_[words]);
        }
    }

    [[nodiscard]] NeighbourFinding words_of(int index) const {
        NeighbourFinding finding;
        finding.difference = difference_;
        if (difference_ <= rounded * found_[index].error) finding.kind = Neighbours::overlap;
        for (; found_[index].parent >= 0; index = found_[index].parent) {
            const Neighbour& n = found_[index];
            (n.inner ? finding.second : finding.first).push_back(n.letter);
        }
        const auto& [a, b] = first_words_[found_[index].letter];
        finding.first.push_back(a);
        finding.second.push_back(b);
        std::ranges::reverse(finding.first);
        std::ranges::reverse(finding.second);
        return finding;
    }

    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    double size_ = 0;
    double unit_ = 0;  // the error of a map's place, over the size
    std::vector<Affine> inverse_;
    std::vector<double> stretch_;          // Lipschitz constants of the maps
    std::vector<double> inverse_stretch_;  // and of their inverses
    bool similitudes_ = true;
    std::vector<std::array<int, 2>> first_words_;
    std::vector<std::array<int, 2>> begins_;  // which of these, and the neighbour that it is
    std::vector<Neighbour> found_;
    std::vector<std::vector<int>> leads_to_;
    std::map<Key, int> index_;
    std::optional<int> nearest_;  // of those that are nearly the identity
    double difference_ = 0;       // from it
};

}  // namespace

NeighbourFinding find_neighbours(const Rifs& rifs, const std::vector<Bounds>& bounds) {
    long pairs = 0;
    for (const FollowSet& set : rifs.follow_sets) {
        pairs += static_cast<long>(set.maps.size()) * (static_cast<long>(set.maps.size()) - 1) / 2;
    }
    if (pairs > static_cast<long>(most_neighbours)) return {};
    return Search(rifs, bounds).run();
}

}  // namespace pxm::host
