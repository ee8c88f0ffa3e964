// What a render counts and measures, for --stats (docs/command-line.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/engine/frame.hpp"
#include "host/node_program/link.hpp"
#include "host/scene/scene.hpp"
#include "pxm/cost.hpp"

namespace pxm::host {

/// Counts of a whole frame, or of one node.
struct RayStatistics {
    std::uint64_t pixels = 0;
    std::uint64_t eye_rays = 0;
    std::uint64_t light_rays = 0;    // shadow rays
    std::uint64_t reflect_rays = 0;  // mirror rays
    std::uint64_t hits = 0;          // pixels whose first eye ray met something
    std::uint64_t volumes_tested = 0;
    std::uint64_t heap_pushes = 0;
    std::uint64_t heap_peak = 0;
    std::uint64_t heap_overflows = 0;  // rays that dropped a cell
    std::uint64_t restarts = 0;        // rays finished by next_after
    std::uint64_t capped_rays = 0;
    std::uint64_t overflowed_pixels =
        0;  // a result was beyond the numbers' range (dsp32: saturated)

    void add(const RayStatistics& other);
};

struct NodeStatistics {
    int id = 0;
    int column = 0;
    int row = 0;
    RayStatistics rays;
    Tally tally;
    std::uint64_t instructions = 0;
    std::uint64_t cycles = 0;  // the instructions, and the waits for slow memories
};

/// One memory's use, the largest over all nodes.
struct MemoryUse {
    std::int64_t limit_bytes = 0;
    std::int64_t used_bytes = 0;
};

/// What only the machine has.
struct MachineStatistics {
    CostModel costs;
    Tally tally;  // of all nodes
    std::vector<NodeStatistics> nodes;
    MemoryUse fast_memory;
    MemoryUse front_buffer;
    MemoryUse back_buffer;
    MemoryUse zbuffer;
    MemoryUse texture;
};

struct PhaseSeconds {
    double parse = 0;
    double compile = 0;
    double load = 0;
    double render = 0;  // the rays
    double encode = 0;  // beside them, in the same threads: pixels to the bytes of a file
    double write = 0;
    double total = 0;
};

struct Statistics {
    std::string scene;
    std::string engine;  // "native" or "machine"
    std::string model;   // machine only
    std::string numeric;
    PixelSize size;
    int threads = 1;
    std::string threads_because;  // why so many
    PhaseSeconds seconds;
    std::string intersect;          // "heap" or "wide"
    std::string intersect_because;  // why this one
    Rerooted rerooted;
    RayStatistics rays;
    std::vector<Alarm> alarms;
    std::uint64_t scene_block_words = 0;
    std::uint64_t scene_block_hash = 0;
    NodeProgram program;
    std::optional<MachineStatistics> machine;
};

}  // namespace pxm::host
