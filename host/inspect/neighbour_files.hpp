// What `pxm inspect --neighbours -o DIR` writes: the graph of neighbours of each system, and its
// boundary as a scene (docs/neighbours.md, "Files of it").
#pragma once

#include <string>
#include <vector>

#include "host/inspect/inspection.hpp"

namespace pxm::host {

struct NeighbourFile {
    std::string name;
    std::string text;
};

/// Of every system that has finitely many types.
[[nodiscard]] std::vector<NeighbourFile> neighbour_files(const Inspection& inspection);

/// The types with their maps and edges, as JSON.
[[nodiscard]] std::string neighbour_graph_json(const IfsFacts& ifs);
/// The same for Graphviz.
[[nodiscard]] std::string neighbour_graph_dot(const IfsFacts& ifs);
/// A page that shows two cells of each type and where they meet, as far as dots tell it.
[[nodiscard]] std::string neighbour_page(const IfsFacts& ifs);
/// The system without cells that coincide, as a scene; empty if none do, or it has too many maps.
[[nodiscard]] std::string distinct_scene(const IfsFacts& ifs);
/// The boundary as a scene; empty if there is no inside, or it has too many maps for one.
[[nodiscard]] std::string boundary_scene(const IfsFacts& ifs);

}  // namespace pxm::host
