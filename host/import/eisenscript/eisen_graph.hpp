// What an EisenScript builds, without building it: applications of rules that are alike (the same
// rule, as deep, with the same counters and colour) are one node, however often they come.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/import/eisenscript/eisen_text.hpp"

namespace pxm::host {

enum class EisenShape { none, box, sphere };

struct EisenEdge {
    Affine map;
    EisenShape shape = EisenShape::none;
    std::size_t node = 0;  // if it is no shape
    EisenColor color;      // of the shape
};
struct EisenNode {
    std::vector<EisenEdge> edges;
};

/// Node 0 is the whole. Every node leads to shapes, and none to itself.
struct EisenGraph {
    std::vector<EisenNode> nodes;
    double shapes = 0;    // how many the program would draw
    bool grids = false;   // there were some, and they were left out
    bool colored = true;  // edges know their colours
    bool drawn = false;   // rules were drawn from those of a name
};

/// Rules of one name are drawn by their weights, from a sequence that `seed` chooses. Throws
/// EisenUnknown and EisenTooMany.
enum class EisenColors { kept, dropped };
[[nodiscard]] EisenGraph eisen_graph(const EisenScript& script, EisenColors colors,
                                     std::uint64_t seed, std::size_t most_edges);

/// Thrown at a name that is neither a rule nor a shape that is taken.
struct EisenUnknown {
    Position position;
    std::string message;
};
/// Thrown if there are more edges than that: with the colours dropped there may be fewer.
struct EisenTooMany {
    std::string rule;
};

}  // namespace pxm::host
