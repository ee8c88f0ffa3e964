// What a scene will need of every pixel node: the modules of the node program, and bytes of the
// banks.
#pragma once

#include <string>

#include "host/engine/statistics.hpp"
#include "host/node_program/link.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"
#include "host/wide/tables/eligible.hpp"

namespace pxm::host {

struct NodeNeeds {                           // of one node
    std::string model;                       // of the machine that the bytes are for
    NodeProgram program;                     // that is loaded into it
    MachineStatistics memory;                // its banks alone
    bool over_limit = false;                 // a memory would be too small
    Rerooted rerooted;                       // cells near the eye that became objects
    std::vector<wide::ObjectMethod> native;  // how each object is met without the machine
};

/// Of a scene that check_scene found right and whose systems contract. What this version cannot
/// render is left out of the count.
[[nodiscard]] NodeNeeds node_needs(const Scene& scene, Diagnostics& diagnostics);

}  // namespace pxm::host
