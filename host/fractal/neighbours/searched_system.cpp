#include "host/fractal/neighbours/searched_system.hpp"

#include <algorithm>
#include <cmath>

#include "host/fractal/bounds/affine_hull.hpp"
#include "host/fractal/system/graph_facts.hpp"

namespace pxm::host {

namespace {

/// Whether each E_s has points that span the whole subspace. Turns around a smaller one would be
/// different maps, and the same pieces.
bool pieces_fill(const exact::ExactSystem& system, const Rifs& rifs) {
    return std::ranges::all_of(affine_hulls(rifs), [&](const AffineHull& hull) {
        return hull.dimension >= system.field.dimensions;
    });
}

}  // namespace

SearchedSystem::SearchedSystem(const exact::ExactSystem& system, const Rifs& maps,
                               const std::vector<Bounds>& volumes, const NeighbourLimits& most)
    : exact(system),
      rifs(maps),
      bounds(volumes),
      limits(most),
      whole(maps.follow_sets.size() == 1),
      strong(graph_facts(maps).strongly_connected),
      full(whole || pieces_fill(system, maps)),
      graph(neighbour_graph(system, maps, volumes, most)) {}

std::string SearchedSystem::unfinished() const {
    return "the neighbours are " + (graph.finite ? graph.why : "not searched: " + graph.why);
}

double SearchedSystem::log_ratio(int map) const {
    if (map < 0) return 0;
    const exact::Polynomial& squared = exact.squared_ratio[static_cast<std::size_t>(map)];
    return std::log(exact.numbers.approximate(element(squared))) / 2;
}

int SearchedSystem::sign(const exact::Polynomial& p) const {
    return exact.numbers.sign(element(p));
}

exact::Algebraic SearchedSystem::element(const exact::Polynomial& p) const {
    exact::Algebraic a = exact.numbers.lifted(exact::whole(0));
    a.value = p;
    return a;
}

}  // namespace pxm::host
