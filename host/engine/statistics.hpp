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
    std::uint64_t pixels = 0;          // rendered
    std::uint64_t eye_rays = 0;        // from the eye
    std::uint64_t light_rays = 0;      // shadow rays
    std::uint64_t reflect_rays = 0;    // mirror rays
    std::uint64_t hits = 0;            // pixels whose first eye ray met something
    std::uint64_t volumes_tested = 0;  // by all rays
    std::uint64_t heap_pushes = 0;     // cells put into the heap
    std::uint64_t heap_peak = 0;       // most cells in it at a time
    std::uint64_t heap_overflows = 0;  // rays that dropped a cell
    std::uint64_t restarts = 0;        // rays finished by next_after
    std::uint64_t capped_rays = 0;     // rays that were given up
    std::uint64_t overflowed_pixels =
        0;  // a result was beyond the numbers' range (dsp32: saturated)

    void add(const RayStatistics& other);  // adds what another has counted
};

struct NodeStatistics {              // of one node
    int id = 0;                      // row * columns + column
    int column = 0;                  // of the array of nodes
    int row = 0;                     // of the same
    RayStatistics rays;              // of its pixels
    Tally tally;                     // of its operations
    std::uint64_t instructions = 0;  // by the cost model
    std::uint64_t cycles = 0;        // the instructions, and the waits for slow memories
};

/// One memory's use, the largest over all nodes.
struct MemoryUse {
    std::int64_t limit_bytes = 0;  // that there are
    std::int64_t used_bytes = 0;   // by the node that uses most
};

/// What only the machine has.
struct MachineStatistics {
    CostModel costs;                    // of its operations
    Tally tally;                        // of all nodes
    std::vector<NodeStatistics> nodes;  // in the order of their ids
    MemoryUse fast_memory;              // program, constants, stack
    MemoryUse front_buffer;             // the picture
    MemoryUse back_buffer;              // the scene
    MemoryUse zbuffer;                  // the heap
    MemoryUse texture;                  // textures
};

struct PhaseSeconds {    // of the clock
    double parse = 0;    // text to scene
    double compile = 0;  // scene to what engines take
    double load = 0;     // that into an engine
    double render = 0;   // the rays
    double encode = 0;   // beside them, in the same threads: pixels to the bytes of a file
    double write = 0;    // to end the file
    double total = 0;    // all of it
};

struct Statistics {                            // of one render
    std::string scene;                         // its path or name
    std::string engine;                        // "native" or "machine"
    std::string model;                         // machine only
    std::string numeric;                       // dsp32, float or double
    PixelSize size;                            // of the image
    int threads = 1;                           // of the host
    std::string threads_because;               // why so many
    PhaseSeconds seconds;                      // by phase
    std::string intersect;                     // "heap" or "wide"
    std::string intersect_because;             // why this one
    Rerooted rerooted;                         // deep zooms: objects that begin at a cell
    RayStatistics rays;                        // of all pixels
    std::vector<Alarm> alarms;                 // what is doubtful, if anything is
    std::uint64_t scene_block_words = 0;       // broadcast to the nodes
    std::uint64_t scene_block_hash = 0;        // of those words
    NodeProgram program;                       // of a node
    std::optional<MachineStatistics> machine;  // of a machine alone
};

}  // namespace pxm::host
