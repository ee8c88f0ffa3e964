#include "host/fractal/dimension/open_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "host/fractal/bounds/affine_hull.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/bounds/convex_hull.hpp"
#include "host/fractal/bounds/inner_points.hpp"
#include "host/fractal/dimension/exact_word.hpp"
#include "host/fractal/dimension/neighbours.hpp"
#include "host/fractal/dimension/similarity.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "host/fractal/system/growth.hpp"
#include "host/fractal/system/word_sums.hpp"

namespace pxm::host {

namespace {

constexpr double rounding = 1e-11;   // of the attractor's size: lengths that are not told from 0
constexpr double thickness = 0.25;   // of the size: given to open sets around flat attractors
constexpr long pair_limit = 50'000;  // pairs of maps that may come at one place
constexpr long edge_limit = 5'000;
constexpr long word_limit = 50'000;          // words of two maps compared with each other
constexpr double rounding_of_words = 1e-14;  // of places: what products of two maps may be off by
constexpr double told_apart = 1e-16;         // of the size: no difference below was measured
constexpr int hull_rounds = 12;
constexpr int box_rounds = 300;

using Hulls = std::vector<std::optional<ConvexHull>>;

long edges_of(const Rifs& rifs) {
    long edges = 0;
    for (const FollowSet& set : rifs.follow_sets) edges += static_cast<long>(set.maps.size());
    return edges;
}

long pairs_of(const Rifs& rifs) {
    long pairs = 0;
    for (const FollowSet& set : rifs.follow_sets) {
        const long maps = static_cast<long>(set.maps.size());
        pairs += maps * (maps - 1) / 2;
    }
    return pairs;
}

Box box_around(const Points& points, Box box) {
    for (const glm::dvec3& point : points) {
        box.low = glm::min(box.low, point);
        box.high = glm::max(box.high, point);
    }
    return box;
}

double size_of(const std::vector<Points>& inner) {
    double size = 0;
    for (const Points& points : inner) {
        const Box box = box_around(points, {points.front(), points.front()});
        size = std::max(size, glm::length(box.high - box.low));
    }
    return size;
}

std::string names_of(const Rifs& rifs, const std::vector<int>& word) {
    std::string names;
    for (const int m : word) names += (names.empty() ? "" : " ") + rifs.map_names[m];
    return names;
}

std::string spoken_words(const Rifs& rifs, const std::vector<int>& a, const std::vector<int>& b) {
    if (a.size() > 1 || b.size() > 1) {
        return fmt::format("the words {} and {}", names_of(rifs, a), names_of(rifs, b));
    }
    return fmt::format("{} and {}", spoken_name(rifs, a[0]), spoken_name(rifs, b[0]));
}

/// That they are the same is said plainly of equal numbers alone. Else it was measured, and how
/// near they are stands beside it.
std::string coincidence(const Rifs& rifs, MapNumbers numbers, const std::vector<int>& a,
                        const std::vector<int>& b, double difference) {
    const std::string words = spoken_words(rifs, a, b);
    if (numbers == MapNumbers::given && are_exactly_one_map(rifs, a, b)) {
        return words + " are the same map";
    }
    return fmt::format("{} are the same map, up to {:.0e} of the attractor's size", words,
                       std::max(difference, told_apart));
}

/// An affine map up to rounding, to look equal ones up.
using MapKey = std::array<double, 13>;

MapKey key_of(const Affine& map, int follow_set, double size) {
    constexpr double digits = 1e10;
    MapKey key{};
    std::size_t k = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) key[k++] = std::round(map.linear[i][j] * digits) + 0.0;
        key[k++] = std::round(map.translation[i] / size * digits) + 0.0;
    }
    key[k] = follow_set;
    return key;
}

/// How far from each other two maps take a point of the ball at most.
double difference(const Affine& a, const Affine& b, const Ball& ball) {
    const glm::dmat3 linear = a.linear - b.linear;
    double squares = 0;
    for (int i = 0; i < 3; ++i) squares += glm::dot(linear[i], linear[i]);
    return glm::distance(a.point(ball.center), b.point(ball.center)) +
           std::sqrt(squares) * ball.radius;
}

/// Words of one or two maps, to find two that are the same map up to rounding.
class ShortWords {
  public:
    ShortWords(const Rifs& rifs, const std::vector<Bounds>& bounds, double size)
        : rifs_(rifs), bounds_(bounds), size_(size) {}

    struct Pair {
        std::vector<int> first;
        std::vector<int> second;
        double difference = 0;  // over the size
    };

    std::optional<Pair> equal_ones() {
        const long edges = edges_of(rifs_);
        for (const FollowSet& set : rifs_.follow_sets) {
            known_.clear();
            for (const int m : set.maps) {
                if (auto pair = add({m}, rifs_.maps[m])) return pair;
                if (edges * edges > word_limit) continue;
                for (const int n : rifs_.follow_sets[rifs_.follow_of[m]].maps) {
                    const Affine map = then(rifs_.maps[n], rifs_.maps[m]);
                    if (auto pair = add({m, n}, map)) return pair;
                }
            }
        }
        return std::nullopt;
    }

  private:
    struct Word {
        std::vector<int> maps;
        Affine map;
    };

    std::optional<Pair> add(const std::vector<int>& maps, const Affine& map) {
        const int inside = rifs_.follow_of[maps.back()];
        const auto [known, fresh] = known_.emplace(key_of(map, inside, size_), Word{maps, map});
        const Word& other = known->second;
        if (fresh || other.maps.front() == maps.front()) return std::nullopt;
        const Ball& ball = bounds_[static_cast<std::size_t>(inside)].ball;
        const double apart = difference(map, other.map, ball) / size_;
        const double places = glm::length(map.point(ball.center)) / size_;
        if (!(apart <= rounding_of_words * std::max(places, 1.0))) return std::nullopt;
        return Pair{other.maps, maps, apart};
    }

    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    double size_;
    std::map<MapKey, Word> known_;
};

/// Disjoint images inside a bounded open set cannot have more volume than it.
bool volume_grows(const Rifs& rifs) {
    std::vector<double> weight;
    for (const Affine& map : rifs.maps) {
        weight.push_back(std::abs(determinant(map)) * (1 - rounding));
    }
    return growth(map_sums(rifs, weight), cyclic_components(rifs)) == Growth::above_one;
}

bool images_are_inside(const Rifs& rifs, const Hulls& open, double tolerance) {
    for (std::size_t s = 0; s < open.size(); ++s) {
        for (const int m : rifs.follow_sets[s].maps) {
            for (const glm::dvec3& corner : open[rifs.follow_of[m]]->corners) {
                if (!open[s]->contains(rifs.maps[m].point(corner), tolerance)) return false;
            }
        }
    }
    return true;
}

bool images_are_apart(const Rifs& rifs, const Hulls& open, double tolerance) {
    for (const FollowSet& set : rifs.follow_sets) {
        for (std::size_t i = 0; i < set.maps.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const int a = set.maps[i];
                const int b = set.maps[j];
                if (!separated(*open[rifs.follow_of[a]], rifs.maps[a], *open[rifs.follow_of[b]],
                               rifs.maps[b], tolerance)) {
                    return false;
                }
            }
        }
    }
    return true;
}

bool is_feasible(const Rifs& rifs, const Hulls& open, double tolerance) {
    return std::ranges::all_of(open, [](const auto& hull) { return hull.has_value(); }) &&
           images_are_inside(rifs, open, tolerance) && images_are_apart(rifs, open, tolerance);
}

/// Adds to the hull of set s what its maps' images of the other hulls have outside of it. True if
/// there was something.
bool grow_hull(const Rifs& rifs, Hulls& hulls, std::size_t s, double tolerance) {
    bool grown = false;
    for (const int m : rifs.follow_sets[s].maps) {
        const Points corners = hulls[rifs.follow_of[m]]->corners;
        for (const glm::dvec3& corner : corners) {
            const glm::dvec3 image = rifs.maps[m].point(corner);
            if (hulls[s]->contains(image, tolerance)) continue;
            Points points = hulls[s]->corners;
            points.push_back(image);
            hulls[s] = convex_hull(points, tolerance);
            if (!hulls[s]) return false;
            grown = true;
        }
    }
    return grown;
}

/// The convex hulls of the sets, from points of theirs, where they have few corners.
Hulls attractor_hulls(const Rifs& rifs, const std::vector<Points>& inner, double size) {
    const double tolerance = rounding / 10 * size;
    Hulls hulls;
    for (const Points& points : inner) {
        hulls.push_back(
            convex_hull(thickened(points, rounding * size, thickness * size), tolerance));
        if (!hulls.back()) return hulls;
    }
    bool grown = true;
    for (int round = 0; grown && round < hull_rounds; ++round) {
        grown = false;
        for (std::size_t s = 0; s < hulls.size(); ++s) {
            grown = grow_hull(rifs, hulls, s, tolerance) || grown;
            if (!hulls[s]) return hulls;
        }
    }
    return hulls;
}

Points corners_of(const Box& box) {
    Points corners;
    for (const double x : {box.low.x, box.high.x}) {
        for (const double y : {box.low.y, box.high.y}) {
            for (const double z : {box.low.z, box.high.z}) corners.push_back({x, y, z});
        }
    }
    return corners;
}

/// Boxes that their images just fill, where maps take boxes to boxes.
Hulls attractor_boxes(const Rifs& rifs, const std::vector<Points>& inner, double size) {
    std::vector<Box> boxes;
    for (const Points& points : inner) {
        boxes.push_back(box_around(points, {points.front(), points.front()}));
    }
    for (int round = 0; round < box_rounds; ++round) {
        for (std::size_t s = 0; s < boxes.size(); ++s) {
            for (const int m : rifs.follow_sets[s].maps) {
                Points corners = corners_of(boxes[rifs.follow_of[m]]);
                for (glm::dvec3& corner : corners) corner = rifs.maps[m].point(corner);
                boxes[s] = box_around(corners, boxes[s]);
            }
        }
    }
    Hulls hulls;
    for (const Box& box : boxes) {
        hulls.push_back(convex_hull(thickened(corners_of(box), rounding * size, thickness * size),
                                    rounding / 10 * size));
    }
    return hulls;
}

/// Why there can be no open sets, if that is known.
std::optional<std::string> obstacle(const Rifs& rifs, const std::vector<Bounds>& bounds,
                                    MapNumbers numbers, const NeighbourFinding& neighbours,
                                    double size) {
    if (neighbours.kind == Neighbours::overlap) {
        return coincidence(rifs, numbers, neighbours.first, neighbours.second,
                           neighbours.difference);
    }
    if (neighbours.kind == Neighbours::unknown) {
        if (const auto words = ShortWords(rifs, bounds, size).equal_ones()) {
            return coincidence(rifs, numbers, words->first, words->second, words->difference);
        }
    }
    if (volume_grows(rifs)) {
        return "the maps' determinants add up to more than 1: bounded images would overlap";
    }
    const int dimension = recurrent_dimension(rifs, affine_hulls(rifs));
    const auto similarity = similarity_dimension(rifs);
    if (similarity && dimension > 0 && similarity->low > dimension * (1 + rounding)) {
        return fmt::format("the similarity dimension is more than the {} of the {} it lies in",
                           dimension, hull_name(dimension));
    }
    return std::nullopt;
}

/// An open set, if one is known.
std::optional<std::string> open_set(const Rifs& rifs, const NeighbourFinding& neighbours,
                                    double size) {
    if (neighbours.kind == Neighbours::apart) {
        return "the images are disjoint, so that a little around the attractor is such a set";
    }
    const std::vector<Points> inner = inner_points(rifs);
    const double tolerance = rounding * size;
    // Boxes first: they take less time.
    if (is_feasible(rifs, attractor_boxes(rifs, inner, size), tolerance)) {
        return "the inside of the attractor's box is such a set";
    }
    if (is_feasible(rifs, attractor_hulls(rifs, inner, size), tolerance)) {
        return "the inside of the attractor's convex hull is such a set";
    }
    if (neighbours.kind == Neighbours::finite && similarity_dimension(rifs)) {
        return fmt::format("pieces touch in {} ways, and no two are the same [BG92]",
                           neighbours.count);
    }
    return std::nullopt;
}

/// Precondition: every set of the system recurs.
OpenSetFinding decide(const Rifs& rifs, const std::vector<Bounds>& bounds, MapNumbers numbers) {
    const double size = size_of(inner_points(rifs));
    if (!(size > 0)) return {OpenSetCondition::unknown, "the attractor is one point"};
    const NeighbourFinding neighbours = find_neighbours(rifs, bounds);
    if (auto why = obstacle(rifs, bounds, numbers, neighbours, size))
        return {OpenSetCondition::fails, *why};
    if (pairs_of(rifs) > pair_limit || edges_of(rifs) > edge_limit) {
        return {OpenSetCondition::unknown,
                fmt::format("not tried: over the limits of {} pairs of maps and {} edges",
                            pair_limit, edge_limit)};
    }
    if (auto why = open_set(rifs, neighbours, size)) return {OpenSetCondition::holds, *why};
    if (neighbours.kind == Neighbours::unknown && !neighbours.first.empty()) {
        return {OpenSetCondition::unknown,
                fmt::format("{} are the same map up to {:.0e} of the attractor's size: neither "
                            "equal nor far enough from it",
                            spoken_words(rifs, neighbours.first, neighbours.second),
                            neighbours.difference)};
    }
    return {OpenSetCondition::unknown,
            "neither the inside of the box nor that of the convex hull is such a set, and there "
            "are too many ways for pieces to touch"};
}

}  // namespace

OpenSetFinding decide_open_set(const Rifs& rifs, const std::vector<Bounds>& bounds,
                               MapNumbers numbers) {
    if (rifs.maps.size() == 1) return {OpenSetCondition::holds, "there is only one map"};
    if (!branches(rifs)) {
        return {OpenSetCondition::holds, "no map has two that may follow for ever"};
    }
    const RecurrentPart part = recurrent_part(rifs);
    std::vector<Bounds> of_part;
    for (const int s : part.sets) of_part.push_back(bounds[s]);
    return decide(part.rifs, of_part, numbers);
}

}  // namespace pxm::host
