#include "host/fractal/neighbours/exact_boundary.hpp"

#include <optional>

#include "host/fractal/neighbours/exact_inside.hpp"
#include "host/fractal/neighbours/graph_growth.hpp"

namespace pxm::host {

Decided<double> exact_boundary(const SearchedSystem& searched, const ExactFindings& found) {
    if (found.interior.value && !*found.interior.value) {
        return {found.hausdorff.value,
                found.hausdorff.value ? "without inside, it is its own boundary"
                                      : "it is its own boundary, whose dimension is not known: " +
                                            found.hausdorff.why};
    }
    if (!found.interior.value) {
        return {std::nullopt, found.interior.why};
    }
    if (is_interval(searched, found)) {
        return {0.0, "the two ends of an interval"};
    }
    if (!searched.similar()) {
        return {std::nullopt, "not every map is a similitude"};
    }
    GrowthGraph graph(searched.graph.types.size());
    for (std::size_t t = 0; t < graph.size(); ++t)
        for (const NeighbourEdge& e : searched.graph.types[t].edges)
            graph[t].push_back({e.to, searched.log_ratio(e.first)});
    const auto exponent = growth_exponent(graph);
    if (!exponent) {
        return {std::nullopt, "it has no neighbours"};
    }
    return {exponent->middle(),
            "where cells meet their neighbours, a graph-directed set [DKV00] "
            "[Falconer95]"};
}

}  // namespace pxm::host
