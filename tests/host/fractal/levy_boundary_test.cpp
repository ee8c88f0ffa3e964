// The boundary of the Levy dragon as a RIFS that is found by an algorithm: its dimension is 1.934
// [DK99].
// Cells u and v of one level are neighbours of type h = f_u^-1 f_v, an isometry. Down a level, type
// h becomes f_i^-1 h f_j, and L meets h(L) if and only if types go on for ever without leaving the
// distance at which two tiles can touch. Tiles that tile do not overlap, so L meets h(L) in
// boundary alone; no point lies in more than a bounded number of tiles, so the number of paths
// grows as the number of cells of the boundary does.
#include <gtest/gtest.h>

#include <complex>
#include <map>
#include <set>
#include <tuple>

#include "host/fractal/dimension/similarity.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

/// z -> i^quarters z + (x + i y), all integers: exact.
struct Neighbor {
    int quarters = 0;
    int x = 0;
    int y = 0;
    auto operator<=>(const Neighbor&) const = default;
};

using Complex = std::complex<double>;
constexpr Complex i{0, 1};
const Complex turn[2] = {(1.0 + i) / 2.0, (1.0 - i) / 2.0};  // f_k(z) = turn[k] z + offset[k]
const Complex offset[2] = {0, (1.0 + i) / 2.0};

/// f_a^-1 h f_b. Its numbers are small halves of integers: double is exact.
Neighbor inside(const Neighbor& h, int a, int b) {
    const Complex quarter[4] = {1, i, -1, -i};
    const Complex rotation = quarter[h.quarters] * turn[b] / turn[a];
    const Complex place =
        (quarter[h.quarters] * offset[b] + Complex(h.x, h.y) - offset[a]) / turn[a];
    Neighbor result{0, static_cast<int>(std::lround(place.real())),
                    static_cast<int>(std::lround(place.imag()))};
    EXPECT_EQ(place, Complex(result.x, result.y));
    while (std::abs(quarter[result.quarters] - rotation) > 1e-9) ++result.quarters;
    return result;
}

/// Levy's dragon lies within 2 of 0 (it contains 0 and is 2 wide): neighbours are within 4.
bool near(const Neighbor& h) { return h.x * h.x + h.y * h.y <= 16; }

struct Step {
    int map;  // the part of L that holds the meeting
    Neighbor next;
};
using Graph = std::map<Neighbor, std::vector<Step>>;

/// All types that come of two different cells, as far as they stay near.
Graph reachable_types() {
    Graph graph;
    std::vector<Neighbor> open{inside({}, 0, 1), inside({}, 1, 0)};
    while (!open.empty()) {
        const Neighbor h = open.back();
        open.pop_back();
        if (graph.contains(h)) continue;
        std::vector<Step>& steps = graph[h];
        for (int a = 0; a < 2; ++a) {
            for (int b = 0; b < 2; ++b) {
                const Neighbor next = inside(h, a, b);
                if (!near(next)) continue;
                steps.push_back({a, next});
                open.push_back(next);
            }
        }
    }
    return graph;
}

/// Without the types from which every path leaves: those tiles do not meet.
void trim(Graph& graph) {
    for (std::size_t before = 0; before != graph.size();) {
        before = graph.size();
        for (auto& [h, steps] : graph) {
            std::erase_if(steps, [&](const Step& step) { return !graph.contains(step.next); });
        }
        std::erase_if(graph, [](const auto& entry) { return entry.second.empty(); });
    }
}

/// A map for each edge: what follows it are the edges out of where it leads.
Rifs boundary_of(const Graph& graph) {
    std::map<Neighbor, std::vector<int>> out;
    std::vector<Affine> maps;
    std::vector<Neighbor> ends;
    for (const auto& [h, steps] : graph) {
        for (const Step& step : steps) {
            out[h].push_back(static_cast<int>(maps.size()));
            maps.push_back(systems::map({scaling(glm::dvec3{std::sqrt(0.5)}),
                                         rotation(Axis::z, step.map == 0 ? 45 : -45)}));
            ends.push_back(step.next);
        }
    }
    std::vector<std::vector<int>> follow;
    for (const Neighbor& end : ends) follow.push_back(out.at(end));
    return systems::with_graph(maps, follow);
}

TEST(LevyDragon, its_boundary_has_dimension_1_934) {
    Graph graph = reachable_types();
    EXPECT_FALSE(graph.contains(Neighbor{})) << "different cells never coincide";
    trim(graph);
    EXPECT_NEAR(similarity_dimension(boundary_of(graph)).value().middle(), 1.934007183, 1e-6);
}

}  // namespace
}  // namespace pxm::host
