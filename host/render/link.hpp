// The linker of the node program: takes the modules a scene needs, leaves the rest out, and says
// why.
#pragma once

#include <string>
#include <vector>

#include "host/render/compiled_scene.hpp"

namespace pxm::host {

/// A module of the node program, and why it is in or left out.
struct ProgramModule {
    std::string name;
    std::string because;
};

/// What is loaded into every node.
struct NodeProgram {
    std::vector<ProgramModule> modules;
    std::vector<ProgramModule> left_out;
};

[[nodiscard]] NodeProgram link(const CompiledScene& scene);

}  // namespace pxm::host
