#include "host/fractal/system/rifs.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "host/fractal/system/components.hpp"

namespace pxm::host {

namespace {

std::string quoted_unless_number(const std::string& name) {
    const bool number = !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) != 0;
    return number ? name : '"' + name + '"';
}

}  // namespace

std::string spoken_name(const Rifs& rifs, int map) {
    return "map " + quoted_unless_number(rifs.map_names[map]);
}

std::vector<std::vector<int>> strong_components(const Rifs& rifs) {
    const std::vector<int> component = component_numbers(descent_graph(rifs));
    std::vector<std::vector<int>> by_number(
        static_cast<std::size_t>(*std::max_element(component.begin(), component.end())) + 1);
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        by_number[component[m]].push_back(static_cast<int>(m));
    }
    std::erase_if(by_number, [](const std::vector<int>& maps) { return maps.empty(); });
    return by_number;
}

}  // namespace pxm::host
