// The engines: the same node programs on the simulated machine or on the cores at hand.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "host/output/cost_model_json.hpp"
#include "host/render/compiled_scene.hpp"
#include "host/render/frame.hpp"
#include "host/render/statistics.hpp"
#include "pxm/model.hpp"

namespace pxm::host {

/// Which engine, and how.
struct EngineChoice {
    const Model* machine = nullptr;  // null: native
    Numeric numeric = Numeric::single;
    int threads = 1;                 // host threads, at least 1
    std::int64_t program_bytes = 0;  // what a node of the machine loads, constants included
    std::int64_t stack_bytes = 0;
    CostModel costs = default_cost_model();
    IntersectMethod intersect = IntersectMethod::heap;  // as chosen: not automatic
};

/// How a render is watched and stopped from outside.
struct RunControl {
    const std::atomic<bool>* stop = nullptr;         // set: give up soon
    std::function<void(double)> progress = nullptr;  // share done, 0..1; called from any thread
};

/// A gathered picture with its counts. `stopped`: the run was given up and the frame is incomplete.
struct EngineResult {
    Frame frame;
    RayStatistics rays;
    std::uint64_t scene_block_words = 0;
    std::uint64_t scene_block_hash = 0;
    std::optional<MachineStatistics> machine;
    double load_seconds = 0;
    double render_seconds = 0;
    bool stopped = false;
};

/// Broadcasts the scene to the nodes of a simulated machine and runs them. A bank that is too small
/// is an Error(ExitCode::machine_limit).
[[nodiscard]] EngineResult run_on_machine(const CompiledScene& scene, const EngineChoice& choice,
                                          const RunControl& control);

/// Renders 8x8 tiles (one pixel of each of the 64 nodes) with OpenMP.
[[nodiscard]] EngineResult run_natively(const CompiledScene& scene, const EngineChoice& choice,
                                        const RunControl& control);

/// One pixel with everything that happened to cells on its ray, as text (`--pixel x,y`).
[[nodiscard]] std::string describe_pixel(const CompiledScene& scene, Numeric numeric, long x,
                                         long y);

}  // namespace pxm::host
