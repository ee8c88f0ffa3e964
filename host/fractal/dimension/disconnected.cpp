#include "host/fractal/dimension/disconnected.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <numeric>

#include "host/fractal/bounds/inner_points.hpp"
#include "host/fractal/dimension/neighbours.hpp"
#include "host/fractal/system/growth.hpp"
#include "host/fractal/system/word_sums.hpp"
#include "host/math/lipschitz.hpp"
#include "host/math/rounding.hpp"

namespace pxm::host {

namespace {

constexpr double same_point = 1e-11;    // of the attractor's size: points nearer are one
constexpr double smallest_cell = 1e-8;  // of the size: cells this small that are not apart touch
// Of the size and of places: no less keeps cells apart, beside what rounding took, so that the
// answer is that of all systems whose constants differ by as little (scene_error).
constexpr double gap = 1e-12;
constexpr long edge_limit =
    20'000;  // maps that may come somewhere, for the search of common points
constexpr long pair_limit = 50'000;        // pairs of maps that may come at one place
constexpr long cell_pair_limit = 300'000;  // pairs of cells compared

/// Theorem 3.9; with a graph, the sums are a matrix, and its spectral radius counts.
bool constants_add_up_to_less(const Rifs& rifs) {
    std::vector<double> lip;
    for (const Affine& map : rifs.maps) lip.push_back(lipschitz_constant(map));
    return growth(map_sums(rifs, lip), cyclic_components(rifs)) == Growth::below_one;
}

/// Theorem 3.8: whether images of the attractor keep apart, by pairs of cells.
class PairSearch {
  public:
    PairSearch(const Rifs& rifs, const std::vector<Bounds>& bounds) : rifs_(rifs), bounds_(bounds) {
        double places = 0;
        for (const Bounds& b : bounds) {
            size_ = std::max(size_, b.ball.radius);
            places = std::max(places, glm::length(b.ball.center));
        }
        gap_ = gap * (size_ + places);
    }

    bool all_images_are_apart() {
        long pairs = 0;
        for (const FollowSet& set : rifs_.follow_sets) {
            pairs += static_cast<long>(set.maps.size()) * static_cast<long>(set.maps.size()) / 2;
        }
        if (pairs > pair_limit) return false;
        for (const FollowSet& set : rifs_.follow_sets) {
            for (std::size_t i = 0; i < set.maps.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    if (!are_apart(image(set.maps[i]), image(set.maps[j]))) return false;
                }
            }
        }
        return true;
    }

  private:
    struct Cell {
        Affine place;
        int set = 0;
        Ball ball;
        Box box;
        double place_error = 0;  // by which the place of a point may be off
        double error = 0;        // ... and what the ball and the box may be short by, for rounding
    };

    /// What places may be off by once `map` is composed with the place of a cell.
    [[nodiscard]] double rounding_inside(const Affine& place, const Affine& map, int set) const {
        const Box& box = bounds_[set].box;
        const glm::dvec3 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
        const glm::dvec3 inner = terms_of(map.linear, farthest, map.translation);
        return rounding_of(sum_of_parts(terms_of(place.linear, inner, place.translation)));
    }
    Cell make(const Affine& place, int set, double place_error) const {
        const Bounds& b = bounds_[set];
        const glm::dvec3 half = (b.box.high - b.box.low) / 2.0;
        const glm::dvec3 middle = place.point((b.box.low + b.box.high) / 2.0);
        glm::dvec3 reach{0.0};
        for (int i = 0; i < 3; ++i) reach += glm::abs(place.linear[i]) * half[i];
        const Ball ball{place.point(b.ball.center), lipschitz_constant(place) * b.ball.radius};
        // Singular values are off by a few roundings of the largest.
        const double own = rounding_inside(Affine{}, place, set) +
                           rounding_of(4 * ball.radius + sum_of_parts(ball.center));
        return {
            place, set, ball, {middle - reach, middle + reach}, place_error, place_error + 2 * own};
    }
    [[nodiscard]] bool bounds_are_apart(const Cell& a, const Cell& b) const {
        const double least = gap_ + a.error + b.error;
        const double reach = a.ball.radius + b.ball.radius + least;
        if (glm::distance(a.ball.center, b.ball.center) > reach) return true;
        return glm::any(glm::greaterThan(a.box.low, b.box.high + least)) ||
               glm::any(glm::greaterThan(b.box.low, a.box.high + least));
    }
    Cell image(int m) const { return make(rifs_.maps[m], rifs_.follow_of[m], 0); }

    /// Two cells that were not told apart; those inside the larger one come next.
    struct Pair {
        Cell large;
        Cell small;
        std::size_t next = 0;  // of the maps inside `large`
    };

    /// Depth first, with one pair a level in memory: numbers of the scene decide how many pairs
    /// there are, not how many are kept.
    bool are_apart(const Cell& a, const Cell& b) {
        std::vector<Pair> path;
        const auto add = [&](const Cell& x, const Cell& y) {
            if (bounds_are_apart(x, y)) return;
            const bool ordered = !(x.ball.radius < y.ball.radius);
            path.push_back(ordered ? Pair{x, y} : Pair{y, x});
        };
        if (++looked_at_ > cell_pair_limit) return false;
        add(a, b);
        while (!path.empty()) {
            Pair& pair = path.back();
            if (pair.large.ball.radius + pair.small.ball.radius < smallest_cell * size_) {
                return false;  // they touch
            }
            const std::vector<int>& maps = rifs_.follow_sets[pair.large.set].maps;
            if (pair.next == maps.size()) {
                path.pop_back();
                continue;
            }
            if (++looked_at_ > cell_pair_limit) return false;
            const int m = maps[pair.next++];
            const Affine& map = rifs_.maps[m];
            const int set = rifs_.follow_of[m];
            const double error =
                pair.large.place_error + rounding_inside(pair.large.place, map, set);
            const Cell inner = make(then(map, pair.large.place), set, error);
            add(inner, Cell{pair.small});
        }
        return true;
    }

    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    double size_ = 0;
    double gap_ = 0;
    long looked_at_ = 0;
};

/// The images of a set's maps hang together if the graph of those that share a point does.
class Joints {
  public:
    Joints(const Rifs& rifs, const std::vector<Points>& inner, double tolerance)
        : rifs_(rifs), inner_(inner), tolerance_(tolerance) {}

    /// `touching`: pairs of maps whose images in one set have common points anyway.
    bool hang_together(const FollowSet& set, const std::vector<std::array<int, 2>>& touching) {
        leader_.assign(rifs_.maps.size(), nowhere);
        for (const int m : set.maps) leader_[m] = m;
        for (const auto& [a, b] : touching) {
            if (leader_[a] != nowhere && leader_[b] != nowhere) leader_[find(a)] = find(b);
        }
        std::vector<Place> places;
        for (const int m : set.maps) {
            for (const glm::dvec3& point : inner_[rifs_.follow_of[m]]) {
                const glm::dvec3 image = rifs_.maps[m].point(point);
                places.push_back({glm::dot(image, across), image, m});
            }
        }
        std::ranges::sort(places, {}, &Place::along);
        for (std::size_t i = 0; i < places.size(); ++i) link_with_next(places, i);
        const int first = find(set.maps.front());
        return std::ranges::all_of(set.maps, [&](int m) { return find(m) == first; });
    }

  private:
    /// A point of the image of a map, and how far it lies along a direction in which different
    /// points hardly ever come together.
    struct Place {
        double along;
        glm::dvec3 point;
        int map;
    };
    static constexpr int nowhere = -1;
    static constexpr glm::dvec3 across{0.5241, 0.6173, 0.5867};

    void link_with_next(const std::vector<Place>& places, std::size_t i) {
        constexpr std::size_t looked_at = 8;  // others may lie between
        const std::size_t end = std::min(places.size(), i + 1 + looked_at);
        for (std::size_t j = i + 1; j < end; ++j) {
            if (places[j].along - places[i].along > tolerance_) return;
            if (glm::distance(places[i].point, places[j].point) > tolerance_) continue;
            leader_[find(places[i].map)] = find(places[j].map);
        }
    }

    int find(int m) {
        while (leader_[m] != m) m = leader_[m] = leader_[leader_[m]];
        return m;
    }

    const Rifs& rifs_;
    const std::vector<Points>& inner_;
    double tolerance_;
    std::vector<int> leader_;
};

double extent(const Points& points) {
    double largest = 0;
    for (const glm::dvec3& point : points) {
        largest = std::max(largest, glm::distance(point, points.front()));
    }
    return largest;
}

/// If the images hang together for a set and for all it leads to, it is connected: its cells of any
/// depth are linked by chains. True if such a set has two points.
bool has_connected_piece(const Rifs& rifs, const std::vector<std::array<int, 2>>& touching) {
    const std::vector<Points> inner = inner_points(rifs);
    double size = 0;
    double places = 0;
    for (const Points& points : inner) {
        size = std::max(size, extent(points));
        places = std::max(places, glm::length(points.front()));
    }
    const double tolerance = same_point * (size + places);
    if (!(tolerance < smallest_cell * size)) return false;  // too far away to tell points apart
    Joints joints(rifs, inner, tolerance);
    std::vector<char> connected;
    for (const FollowSet& set : rifs.follow_sets)
        connected.push_back(joints.hang_together(set, touching));
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t s = 0; s < connected.size(); ++s) {
            if (!connected[s]) continue;
            for (const int m : rifs.follow_sets[s].maps) {
                if (!connected[rifs.follow_of[m]]) connected[s] = 0;
            }
            changed = changed || !connected[s];
        }
    }
    for (std::size_t s = 0; s < connected.size(); ++s) {
        if (connected[s] && extent(inner[s]) > 100 * smallest_cell * size) return true;
    }
    return false;
}

bool all_injective(const Rifs& rifs) {
    return std::ranges::none_of(
        rifs.maps, [](const Affine& map) { return classify(map) == MapKind::singular; });
}

long edges_of(const Rifs& rifs) {
    long edges = 0;
    for (const FollowSet& set : rifs.follow_sets) edges += static_cast<long>(set.maps.size());
    return edges;
}

}  // namespace

DisconnectedFinding decide_disconnected(const Rifs& rifs, const std::vector<Bounds>& bounds,
                                        double dimension_upper) {
    if (constants_add_up_to_less(rifs)) {
        return {true, "the Lipschitz constants add up to less than 1 (Theorem 3.9)"};
    }
    if (dimension_upper < 1) return {true, "its dimension is below 1"};
    const bool few = edges_of(rifs) <= edge_limit;
    if (few && has_connected_piece(rifs, {})) {
        return {false, "images that share points make a connected piece of it"};
    }
    if (few) {
        const NeighbourFinding neighbours = find_neighbours(rifs, bounds);
        if (neighbours.complete && neighbours.touching.empty()) {
            return {true, "its images under the maps are disjoint (Theorem 3.8)"};
        }
        if (neighbours.complete && has_connected_piece(rifs, neighbours.touching)) {
            return {false, "images that touch make a connected piece of it"};
        }
    }
    // Theorem 3.8 needs injective maps (Erratum 16).
    if (few && all_injective(rifs) && PairSearch(rifs, bounds).all_images_are_apart()) {
        return {true, "its images under the maps are disjoint (Theorem 3.8)"};
    }
    return {std::nullopt, few ? "its images were neither found disjoint nor linked by points"
                              : "not tried: over the limit of 20000 edges of the graph"};
}

}  // namespace pxm::host
