#include <nlohmann/json.hpp>

#include "host/inspect/neighbour_files.hpp"
#include "host/text/json_text.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

Json name_json(const IfsFacts& ifs, int map) {
    return map < 0 ? Json(nullptr) : Json(ifs.exact_names[static_cast<std::size_t>(map)]);
}

}  // namespace

std::string neighbour_graph_json(const IfsFacts& ifs) {
    const ExactFindings& exact = ifs.exact;
    Json json = {{"ifs", ifs.rifs.name},
                 {"numbers", exact.numbers},
                 {"dimensions", exact.dimensions},
                 {"axes", Json::array()},
                 {"types", Json::array()}};
    constexpr std::array axis_names{"x", "y", "z"};
    for (int i = 0; i < exact.dimensions; ++i)
        json["axes"].push_back(
            axis_names[static_cast<std::size_t>(exact.axes[static_cast<std::size_t>(i)])]);
    for (const TouchingType& type : exact.graph) {
        Json edges = Json::array();
        for (const auto& [first, second, to] : type.edges)
            edges.push_back(
                {{"first", name_json(ifs, first)}, {"second", name_json(ifs, second)}, {"to", to}});
        json["types"].push_back({{"first_set", type.first},
                                 {"second_set", type.second},
                                 {"identity", type.identity},
                                 {"map", type.entries},
                                 {"edges", edges}});
    }
    return json_text(json, 2) + "\n";
}

}  // namespace pxm::host
