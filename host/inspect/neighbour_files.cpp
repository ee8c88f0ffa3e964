#include "host/inspect/neighbour_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace pxm::host {

namespace {

constexpr std::size_t most_maps = 20'000;  // of a boundary's scene

/// A map within the first cell, and the type that it leads to.
using Step = std::array<int, 2>;

/// The steps of a type: edges that leave the first cell whole are followed until one divides it.
void gather(const std::vector<TouchingType>& graph, std::size_t type, std::set<Step>& steps) {
    for (const auto& [first, second, to] : graph[type].edges) {
        if (first >= 0) {
            steps.insert({first, to});
        } else {
            gather(graph, static_cast<std::size_t>(to), steps);
        }
    }
}

std::string step_name(std::size_t type, const Step& step) {
    return fmt::format("t{}_{}_{}", type, step[0] + 1, step[1]);
}

std::string names_of(std::size_t type, const std::set<Step>& steps) {
    std::string names;
    for (const Step& step : steps) names += (names.empty() ? "" : ", ") + step_name(type, step);
    return names;
}

std::string matrix_of(const IfsFacts& ifs, int map) {
    const std::string& name = ifs.exact_names[static_cast<std::size_t>(map)];
    const auto place = std::ranges::find(ifs.rifs.map_names, name) - ifs.rifs.map_names.begin();
    const Affine& affine = ifs.rifs.maps[static_cast<std::size_t>(place)];
    std::string text;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            text += fmt::format("{:.17g},", affine.linear[row][column]);
    return text + fmt::format(" {:.17g},{:.17g},{:.17g}", affine.translation.x,
                              affine.translation.y, affine.translation.z);
}

}  // namespace

std::string boundary_scene(const IfsFacts& ifs) {
    const std::vector<TouchingType>& graph = ifs.exact.graph;
    if (!ifs.exact.interior.value.value_or(false)) return "";
    std::vector<std::set<Step>> steps(graph.size());
    std::size_t maps = 0;
    for (std::size_t t = 0; t < graph.size(); ++t) {
        gather(graph, t, steps[t]);
        maps += steps[t].size();
    }
    if (maps == 0 || maps > most_maps) return "";
    std::string text = fmt::format(
        "# The boundary of {}: where its cells meet their neighbours. Written by pxm inspect.\n"
        "ifs boundary {{\n",
        ifs.rifs.name);
    for (std::size_t t = 0; t < graph.size(); ++t)
        for (const Step& step : steps[t]) {
            const auto to = static_cast<std::size_t>(step[1]);
            text += fmt::format("    newmap {} matrix: {}\n", step_name(t, step),
                                matrix_of(ifs, step[0]));
            text +=
                fmt::format("    follow: {} -> {}\n", step_name(t, step), names_of(to, steps[to]));
        }
    std::string start;
    for (std::size_t t = 0; t < graph.size(); ++t)
        start += (start.empty() || steps[t].empty() ? "" : ", ") + names_of(t, steps[t]);
    return text + "    start: " + start + "\n}\n";
}

std::string distinct_scene(const IfsFacts& ifs) {
    const auto& states = ifs.exact.distinct;
    std::set<std::array<int, 2>> steps;  // a map, and the state after it
    for (const auto& state : states) steps.insert(state.begin(), state.end());
    if (steps.empty() || steps.size() > most_maps) return "";
    const auto name_of = [](const std::array<int, 2>& step) {
        return fmt::format("m{}_{}", step[0] + 1, step[1]);
    };
    const auto names_of_state = [&](int state) {
        std::string names;
        for (const auto& step : states[static_cast<std::size_t>(state)])
            names += (names.empty() ? "" : ", ") + name_of(step);
        return names;
    };
    std::string text = fmt::format(
        "# {} without cells that coincide: words that equal no earlier one. Written by pxm "
        "inspect.\n"
        "ifs distinct {{\n",
        ifs.rifs.name);
    for (const auto& step : steps)
        text += fmt::format("    newmap {} matrix: {}\n", name_of(step), matrix_of(ifs, step[0]));
    for (const auto& step : steps)
        text += fmt::format("    follow: {} -> {}\n", name_of(step), names_of_state(step[1]));
    return text + "    start: " + names_of_state(0) + "\n}\n";
}

std::string neighbour_graph_dot(const IfsFacts& ifs) {
    const auto name = [&](int map) {
        return map < 0 ? "-" : ifs.exact_names[static_cast<std::size_t>(map)];
    };
    std::string text = "digraph neighbours {\n";
    for (std::size_t t = 0; t < ifs.exact.graph.size(); ++t) {
        const TouchingType& type = ifs.exact.graph[t];
        text += fmt::format("    t{} [label=\"{}\"{}];\n", t, t,
                            type.identity ? " shape=doublecircle" : "");
        for (const auto& [first, second, to] : type.edges)
            text += fmt::format("    t{} -> t{} [label=\"{} {}\"];\n", t, to, name(first),
                                name(second));
    }
    return text + "}\n";
}

std::vector<NeighbourFile> neighbour_files(const Inspection& inspection) {
    std::vector<NeighbourFile> files;
    for (const IfsFacts& ifs : inspection.ifs) {
        if (!ifs.exact.finite.value.value_or(false)) continue;
        const std::string& name = ifs.rifs.name;
        files.push_back({name + ".json", neighbour_graph_json(ifs)});
        files.push_back({name + ".dot", neighbour_graph_dot(ifs)});
        // Follow sets are numbered in the part that is reached.
        if (ifs.exact_names == ifs.rifs.map_names)
            files.push_back({name + ".html", neighbour_page(ifs)});
        std::string scene = boundary_scene(ifs);
        if (!scene.empty()) files.push_back({name + "-boundary.pxm", std::move(scene)});
        std::string distinct = distinct_scene(ifs);
        if (!distinct.empty()) files.push_back({name + "-distinct.pxm", std::move(distinct)});
    }
    return files;
}

}  // namespace pxm::host
