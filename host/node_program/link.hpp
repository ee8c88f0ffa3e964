// The linker of the node program: takes the modules a scene needs, leaves the rest out, says why,
// and adds up what that takes of a node's fast memory (docs/program-memory.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/compiled/compiled_scene.hpp"

namespace pxm::host {

/// A module of the node program, and why it is in or left out.
struct ProgramModule {
    std::string name;        // of the module
    std::string because;     // of what it is in or left out
    std::int64_t bytes = 0;  // program and constants, as measured
};

/// What is loaded into every node: all of it lies in fast memory.
struct NodeProgram {
    std::vector<ProgramModule> modules;      // that are in
    std::vector<ProgramModule> left_out;     // that are not
    std::int64_t stack_bytes = 0;            // of the deepest chain of calls
    std::vector<std::string> deepest_calls;  // that chain, from the outside in
    std::int64_t heap_order_bytes = 0;       // the heap's slot numbers, 4 bytes an entry

    /// Program and constants of all modules that are in.
    [[nodiscard]] std::int64_t modules_bytes() const;
    /// All of fast memory that is used.
    [[nodiscard]] std::int64_t used_bytes() const;
};

/// The program for a scene.
[[nodiscard]] NodeProgram link(const CompiledScene& scene);

/// Throws Error(ErrorKind::machine_limit) with the largest parts if the program does not fit into
/// the fast memory of a node of that model.
void require_fit(const NodeProgram& program, const std::string& model);

}  // namespace pxm::host
