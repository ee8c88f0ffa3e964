// A system in exact numbers with its graph of neighbours, and what every question about it asks.
#pragma once

#include <string>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/exact/exact_system.hpp"
#include "host/fractal/neighbours/neighbour_graph.hpp"
#include "host/fractal/neighbours/neighbour_limits.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

inline constexpr const char* flat_pieces =
    "some pieces lie in a smaller line or plane than the maps keep";

struct SearchedSystem {
    /// Searches the graph. What is given is kept by reference.
    SearchedSystem(const exact::ExactSystem& exact, const Rifs& rifs,
                   const std::vector<Bounds>& bounds, const NeighbourLimits& limits);

    [[nodiscard]] bool finite() const { return graph.finite.value_or(false); }
    /// Why the neighbours do not tell something.
    [[nodiscard]] std::string unfinished() const;
    /// Whether every map is a similitude.
    [[nodiscard]] bool similar() const { return !exact.squared_ratio.empty(); }
    /// Of a similitude; 0 for -1, which is no map.
    [[nodiscard]] double log_ratio(int map) const;
    [[nodiscard]] int sign(const exact::Polynomial& p) const;

    const exact::ExactSystem& exact;
    const Rifs& rifs;
    const std::vector<Bounds>& bounds;
    NeighbourLimits limits;
    bool whole;   // one follow set: an IFS
    bool strong;  // the graph of follow sets is strongly connected
    bool full;    // no piece lies in a smaller subspace than the maps keep
    NeighbourGraph graph;

  private:
    [[nodiscard]] exact::Algebraic element(const exact::Polynomial& p) const;
};

}  // namespace pxm::host
