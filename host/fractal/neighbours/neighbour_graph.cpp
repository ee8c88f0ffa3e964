#include "host/fractal/neighbours/neighbour_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace pxm::host {

namespace {

constexpr double margin = 1e-6;      // of a ball's radius, for all rounding
constexpr double most_error = 1e-9;  // of a candidate's entries, before it is not trusted
constexpr int widest = 3;

using Rounded = exact::ExactMap::Rounded;

/// A map of up to three dimensions in double; its error bounds each entry's.
struct Approximate {
    std::array<double, 12> entry{};  // rows with their translation
    double error = 0;
    double size = 0;  // the largest entry
};

double at(const Approximate& m, int n, int row, int column) {
    return m.entry[static_cast<std::size_t>(row * (n + 1) + column)];
}

Approximate approximate(const exact::ExactMap& map, const exact::FieldFacts& field) {
    const Rounded rounded = map.rounded(field);
    Approximate result;
    std::copy(std::begin(rounded.entry), std::end(rounded.entry), result.entry.begin());
    result.error = rounded.error;
    for (const double e : result.entry) result.size = std::max(result.size, std::abs(e));
    return result;
}

Approximate composed(const Approximate& outer, const Approximate& inner, int n) {
    constexpr double rounding = 0x1p-50;
    Approximate result;
    for (int r = 0; r < n; ++r)
        for (int c = 0; c <= n; ++c) {
            double sum = c == n ? at(outer, n, r, n) : 0;
            for (int k = 0; k < n; ++k) sum += at(outer, n, r, k) * at(inner, n, k, c);
            result.entry[static_cast<std::size_t>(r * (n + 1) + c)] = sum;
            result.size = std::max(result.size, std::abs(sum));
        }
    const double products = outer.size * inner.size * n + outer.size;
    result.error = n * (outer.error * (inner.size + inner.error) + outer.size * inner.error) +
                   outer.error + rounding * products * n;
    return result;
}

/// No smaller than the factor by which it stretches lengths, and that for a similitude.
double stretch(const Approximate& m, int n) {
    double largest = 0;
    for (int i = 0; i < n; ++i) {
        double row = 0;
        for (int j = 0; j < n; ++j) {
            double product = 0;
            for (int k = 0; k < n; ++k) product += at(m, n, k, i) * at(m, n, k, j);
            row += std::abs(product);
        }
        largest = std::max(largest, row);
    }
    return std::sqrt(largest);
}

double volume_ratio(const Approximate& m, int n) {
    if (n == 1) return std::abs(at(m, n, 0, 0));
    if (n == 2) return std::abs(at(m, n, 0, 0) * at(m, n, 1, 1) - at(m, n, 0, 1) * at(m, n, 1, 0));
    double sum = 0;
    for (int c = 0; c < n; ++c)
        sum += at(m, n, 0, c) * (at(m, n, 1, (c + 1) % n) * at(m, n, 2, (c + 2) % n) -
                                 at(m, n, 1, (c + 2) % n) * at(m, n, 2, (c + 1) % n));
    return std::abs(sum);
}

struct Sphere {
    std::array<double, widest> center{};
    double radius = 0;
};

class Search {
  public:
    Search(const exact::ExactSystem& system, const Rifs& rifs, const std::vector<Bounds>& bounds,
           const NeighbourLimits& limits)
        : system_(system), rifs_(rifs), limits_(limits), n_(system.field.dimensions) {
        for (const Bounds& b : bounds) add_ball(b.ball);
        // Of two products in exact numbers, in steps, as it was measured.
        constexpr std::size_t fixed = 20, products = 8;
        const auto degree = static_cast<std::size_t>(system.field.degree);
        exact_cost_ = fixed + products * degree * degree;
        identity_ = exact::ExactMap::identity(system.field);
        for (std::size_t m = 0; m < system.maps.size(); ++m) {
            forward_.push_back(approximate(system.maps[m], system.field));
            backward_.push_back(approximate(system.inverses[m], system.field));
        }
    }

    NeighbourGraph run() {
        const auto give_up = [&](std::string why) {
            graph_.finite = false;
            graph_.why = std::move(why);
            return std::move(graph_);
        };
        if (!bounded_) {
            graph_.why = "the exact attractor's bounds are not proven: the maps contract too late";
            return std::move(graph_);
        }
        const Approximate unit = approximate(identity_, system_.field);
        for (std::size_t s = 0; s < rifs_.follow_sets.size(); ++s) {
            const std::vector<int>& maps = rifs_.follow_sets[s].maps;
            std::vector<NeighbourEdge> edges;
            for (const int i : maps)
                for (const int j : maps)
                    if (i != j) meet(identity_, unit, i, j, -1, edges);
            graph_.own.push_back(std::move(edges));
            if (stopped()) return give_up(why_);
        }
        for (std::size_t t = 0; t < graph_.types.size(); ++t) {
            divide(t);
            if (stopped()) return give_up(why_);
        }
        graph_.finite = true;
        remove_dead_ends();
        return std::move(graph_);
    }

  private:
    void add_ball(const Ball& ball) {
        Sphere sphere;
        for (int i = 0; i < n_; ++i)
            sphere.center[static_cast<std::size_t>(i)] =
                ball.center[system_.axes[static_cast<std::size_t>(i)]];
        const double far = std::max(1.0, glm::length(ball.center) + ball.radius);
        if (!(system_.offset * far <= margin / 2 * ball.radius)) bounded_ = false;
        sphere.radius = ball.radius * (1 + margin);
        balls_.push_back(sphere);
    }

    bool stopped() {
        if (graph_.types.size() > limits_.types)
            why_ = fmt::format("not finite within {} types", limits_.types);
        if (steps_ > limits_.steps)
            why_ = fmt::format("not finite within {} steps, {} types so far", limits_.steps,
                               graph_.types.size());
        return !why_.empty();
    }

    /// Proven not to have a common point.
    [[nodiscard]] bool apart(int s, int t, const Approximate& h) const {
        const Sphere& a = balls_[static_cast<std::size_t>(s)];
        const Sphere& b = balls_[static_cast<std::size_t>(t)];
        double squares = 0, reach = 1;
        for (int r = 0; r < n_; ++r) {
            double x = at(h, n_, r, n_) - a.center[static_cast<std::size_t>(r)];
            for (int c = 0; c < n_; ++c)
                x += at(h, n_, r, c) * b.center[static_cast<std::size_t>(c)];
            squares += x * x;
            reach += std::abs(b.center[static_cast<std::size_t>(r)]);
        }
        const double doubt = h.error * n_ * (reach + b.radius);
        return std::sqrt(squares) * (1 - margin) - doubt > a.radius + stretch(h, n_) * b.radius;
    }

    void divide(std::size_t t) {
        const exact::ExactMap map = graph_.types[t].map;
        const int s1 = graph_.types[t].first, s2 = graph_.types[t].second;
        const Approximate h = approximate(map, system_.field);
        const double ratio = system_.equal_ratios ? 1 : volume_ratio(h, n_);
        constexpr double tie = 1e-9;
        static const std::vector<int> whole_cell{-1};
        const std::vector<int>& firsts =
            ratio > 1 + tie ? whole_cell : rifs_.follow_sets[static_cast<std::size_t>(s1)].maps;
        const std::vector<int>& seconds =
            ratio < 1 - tie ? whole_cell : rifs_.follow_sets[static_cast<std::size_t>(s2)].maps;
        std::vector<NeighbourEdge> edges;
        sets_ = {s1, s2};
        for (const int i : firsts)
            for (const int j : seconds) {
                meet(map, h, i, j, static_cast<int>(t), edges);
                if (stopped()) return;
            }
        graph_.types[t].edges = std::move(edges);
    }

    /// The cells f_i and h f_j, where -1 is no map; if they may meet, an edge to their type.
    void meet(const exact::ExactMap& map, const Approximate& h, int i, int j, int from,
              std::vector<NeighbourEdge>& edges) {
        ++steps_;
        if (stopped()) return;
        const auto set = [&](int m, int otherwise) {
            return m < 0 ? otherwise : rifs_.follow_of[static_cast<std::size_t>(m)];
        };
        const int s1 = set(i, sets_[0]), s2 = set(j, sets_[1]);
        Approximate child = j < 0 ? h : composed(h, forward_[static_cast<std::size_t>(j)], n_);
        if (i >= 0) child = composed(backward_[static_cast<std::size_t>(i)], child, n_);
        if (child.error < most_error && apart(s1, s2, child)) return;
        constexpr std::size_t short_bits = 256;
        steps_ += exact_cost_ * (1 + static_cast<std::size_t>(map.bits()) / short_bits);
        exact::ExactMap exact_child = map;
        if (j >= 0)
            exact_child = exact::ExactMap::composed(system_.field, exact_child,
                                                    system_.maps[static_cast<std::size_t>(j)]);
        if (i >= 0)
            exact_child = exact::ExactMap::composed(
                system_.field, system_.inverses[static_cast<std::size_t>(i)], exact_child);
        const std::optional<int> type = type_of(s1, s2, exact_child, from, i, j);
        if (type) edges.push_back({i, j, *type});
    }

    std::optional<int> type_of(int s1, int s2, const exact::ExactMap& map, int from, int i, int j) {
        std::size_t key = map.hash() * 31U + static_cast<std::size_t>(s1);
        key = key * 31U + static_cast<std::size_t>(s2);
        std::vector<int>& same_key = by_key_[key];
        for (const int t : same_key) {
            const NeighbourType& type = graph_.types[static_cast<std::size_t>(t)];
            if (type.first == s1 && type.second == s2 && type.map == map) return t;
        }
        const Approximate rounded = approximate(map, system_.field);
        if (apart(s1, s2, rounded)) return std::nullopt;
        if (!(rounded.error < most_error)) {
            why_ = "numbers grow too long: not finite within 46 bits";
            return std::nullopt;
        }
        NeighbourType type;
        type.first = s1;
        type.second = s2;
        type.map = map;
        type.identity = s1 == s2 && map == identity_;
        type.from = from;
        type.first_map = i;
        type.second_map = j;
        graph_.types.push_back(std::move(type));
        same_key.push_back(static_cast<int>(graph_.types.size()) - 1);
        return same_key.back();
    }

    /// Types without an endless path.
    void remove_dead_ends() {
        std::vector<std::vector<int>> before(graph_.types.size());
        std::vector<int> left(graph_.types.size(), 0), waiting;
        for (std::size_t t = 0; t < graph_.types.size(); ++t) {
            for (const NeighbourEdge& e : graph_.types[t].edges)
                before[static_cast<std::size_t>(e.to)].push_back(static_cast<int>(t));
            left[t] = static_cast<int>(graph_.types[t].edges.size());
            if (left[t] == 0) waiting.push_back(static_cast<int>(t));
        }
        while (!waiting.empty()) {
            const auto t = static_cast<std::size_t>(waiting.back());
            waiting.pop_back();
            graph_.types[t].touches = false;
            for (const int b : before[t])
                if (--left[static_cast<std::size_t>(b)] == 0) waiting.push_back(b);
        }
        const auto dead = [&](const NeighbourEdge& e) {
            return !graph_.types[static_cast<std::size_t>(e.to)].touches;
        };
        for (NeighbourType& type : graph_.types) std::erase_if(type.edges, dead);
        for (auto& edges : graph_.own) std::erase_if(edges, dead);
    }

    const exact::ExactSystem& system_;
    const Rifs& rifs_;
    const NeighbourLimits limits_;
    int n_;
    bool bounded_ = true;
    std::vector<Sphere> balls_;
    exact::ExactMap identity_;
    std::vector<Approximate> forward_;
    std::vector<Approximate> backward_;
    std::array<int, 2> sets_{};
    NeighbourGraph graph_;
    std::unordered_map<std::size_t, std::vector<int>> by_key_;
    std::size_t steps_ = 0;
    std::size_t exact_cost_ = 0;
    std::string why_;
};

}  // namespace

NeighbourGraph neighbour_graph(const exact::ExactSystem& system, const Rifs& rifs,
                               const std::vector<Bounds>& bounds, const NeighbourLimits& limits) {
    NeighbourGraph none;
    if (system.field.dimensions == 0) {
        none.why = "the attractor is a point";
        return none;
    }
    if (system.inverses.empty()) {
        none.why = "a map has no inverse within the attractor's line, plane or space";
        return none;
    }
    return Search(system, rifs, bounds, limits).run();
}

WordPair words_of(const NeighbourGraph& graph, std::size_t type) {
    WordPair words;
    for (int t = static_cast<int>(type); t >= 0;) {
        const NeighbourType& found = graph.types[static_cast<std::size_t>(t)];
        if (found.first_map >= 0) words.first.push_back(found.first_map);
        if (found.second_map >= 0) words.second.push_back(found.second_map);
        t = found.from;
    }
    std::ranges::reverse(words.first);
    std::ranges::reverse(words.second);
    return words;
}

}  // namespace pxm::host
