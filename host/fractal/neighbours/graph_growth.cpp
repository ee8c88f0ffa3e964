#include "host/fractal/neighbours/graph_growth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include "host/fractal/system/components.hpp"

namespace pxm::host {

namespace {

Graph rows_of(const GrowthGraph& graph) {
    Graph rows;
    rows.first.push_back(0);
    for (const auto& steps : graph) {
        for (const GrowthStep& step : steps) rows.targets.push_back(step.to);
        rows.first.push_back(static_cast<int>(rows.targets.size()));
    }
    return rows;
}

/// Of one component, with its states numbered anew.
struct Part {
    GrowthGraph graph;
    bool branches = false;
    bool endless = false;
};

std::vector<Part> parts_of(const GrowthGraph& graph) {
    const std::vector<int> component = component_numbers(rows_of(graph));
    std::map<int, std::vector<int>> members;
    std::vector<int> number(graph.size());
    for (std::size_t s = 0; s < graph.size(); ++s) {
        auto& list = members[component[s]];
        number[s] = static_cast<int>(list.size());
        list.push_back(static_cast<int>(s));
    }
    std::vector<Part> parts;
    for (const auto& [c, list] : members) {
        Part part;
        for (const int s : list) {
            auto& steps = part.graph.emplace_back();
            for (const GrowthStep& step : graph[static_cast<std::size_t>(s)])
                if (component[static_cast<std::size_t>(step.to)] == c)
                    steps.push_back({number[static_cast<std::size_t>(step.to)], step.log_ratio});
            part.branches = part.branches || steps.size() > 1;
            part.endless = part.endless || !steps.empty();
        }
        if (part.endless) parts.push_back(std::move(part));
    }
    return parts;
}

StepMatrix matrix_of(const GrowthGraph& graph, double d) {
    StepMatrix matrix;
    for (const auto& steps : graph) {
        std::map<int, double> row;
        for (const GrowthStep& step : steps) row[step.to] += std::exp(d * step.log_ratio);
        std::vector<int> columns;
        std::vector<double> weights;
        for (const auto& [to, weight] : row) {
            columns.push_back(to);
            weights.push_back(weight);
        }
        matrix.add_row(columns, weights);
    }
    return matrix;
}

/// Of a component all of whose steps make cells smaller alike: the logarithm of the radius of its
/// matrix over that of the ratio, by one power iteration in place of one for each exponent tried.
/// The least and the largest growth of a positive vector's entries hold the radius between them
/// (Collatz and Wielandt). Nothing if ratios differ, or the two do not meet.
std::optional<Interval> exponent_of_one_ratio(const GrowthGraph& graph) {
    constexpr double settled = 1e-13;
    constexpr std::size_t most_work = 200'000'000;  // steps taken
    const double log_ratio = graph.front().front().log_ratio;
    std::size_t steps = 0, terms = 0;
    for (const auto& row : graph) {
        for (const GrowthStep& step : row)
            if (step.log_ratio != log_ratio) return std::nullopt;
        steps += row.size();
        terms = std::max(terms, row.size());
    }
    std::vector<double> x(graph.size(), 1), y(graph.size(), 0);
    for (std::size_t work = 0; work < most_work; work += steps) {
        double least = INFINITY, most = 0, largest = 0;
        for (std::size_t s = 0; s < graph.size(); ++s) {
            double image = 0;
            for (const GrowthStep& step : graph[s]) image += x[static_cast<std::size_t>(step.to)];
            if (!(x[s] > 0)) return std::nullopt;
            least = std::min(least, image / x[s]);
            most = std::max(most, image / x[s]);
            y[s] = image + x[s];  // the matrix may be periodic
            largest = std::max(largest, y[s]);
        }
        if (most - least <= settled * most) {
            const double margin = static_cast<double>(terms + 8) * 0x1p-52;
            return Interval{std::log(least * (1 - margin)) / -log_ratio,
                            std::log(most * (1 + margin)) / -log_ratio};
        }
        for (std::size_t s = 0; s < graph.size(); ++s) x[s] = y[s] / largest;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Interval> growth_exponent(const GrowthGraph& graph) {
    std::optional<Interval> largest;
    for (const Part& part : parts_of(graph)) {
        if (!largest) largest = Interval{};
        if (!part.branches) continue;
        std::vector<std::vector<int>> all(1);
        for (std::size_t s = 0; s < part.graph.size(); ++s) all[0].push_back(static_cast<int>(s));
        const auto at_once = exponent_of_one_ratio(part.graph);
        const Interval found = at_once ? *at_once : critical_exponent([&](double d) {
            return growth(matrix_of(part.graph, d), all);
        });
        if (found.middle() > largest->middle()) largest = found;
    }
    return largest;
}

}  // namespace pxm::host
