// The engines: the same node programs on the simulated machine or on the cores at hand.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/engine/frame.hpp"
#include "host/engine/statistics.hpp"
#include "host/engine/units.hpp"
#include "pxm/cost.hpp"
#include "pxm/model.hpp"

namespace pxm::host {

/// What the nodes of the machine run.
enum class NodeCode {
    counted,    // the kernels, which count what they do
    assembled,  // dsp_kernels/asm, in a node's own instructions (docs/dsp32.md, "The node program")
};

/// Which engine, and how.
struct EngineChoice {
    const Model* machine = nullptr;          // null: native
    Numeric numeric = Numeric::single;       // what nodes compute with
    int threads = 1;                         // host threads, at least 1
    std::int64_t program_bytes = 0;          // what a node of the machine loads, constants included
    std::int64_t stack_bytes = 0;            // of a node of the machine
    CostModel costs = default_cost_model();  // of its instructions
    IntersectMethod intersect = IntersectMethod::heap;  // as chosen: not automatic
    NodeCode code = NodeCode::counted;                  // what the nodes of a machine run
};

/// How a render is watched and stopped from outside.
struct RunControl {
    const std::atomic<bool>* stop = nullptr;         // set: give up soon
    std::function<void(double)> progress = nullptr;  // share done, 0..1; called from any thread
};

/// The control of one of `count` runs that are alike, the `index`th from 0. Keeps a reference to
/// `control`.
[[nodiscard]] inline RunControl share_of(const RunControl& control, std::size_t index,
                                         std::size_t count) {
    RunControl own = control;
    if (!control.progress) return own;
    own.progress = [&control, index, count](double share) {
        control.progress((static_cast<double>(index) + share) / static_cast<double>(count));
    };
    return own;
}

/// Who takes a picture while it is rendered: then nobody keeps a frame of the whole window.
struct BlockTaker {
    /// Takes a part of the window, all of whose pixels are known. Called by any thread, in any
    /// order; the frame is gone afterwards.
    std::function<void(Frame&)> take;
    /// Parts come by bands of about so many rows, from the top: what is put together of them needs
    /// no more memory than two bands.
    long band_rows = 0;
};

/// A gathered picture with its counts. `stopped`: the run was given up and the frame is incomplete.
/// The frame is empty if the picture was taken block by block.
struct EngineResult {
    Frame frame;                               // the window
    RayStatistics rays;                        // counted
    std::optional<MachineStatistics> machine;  // of a machine alone
    double render_seconds = 0;                 // of the rays
    double take_seconds = 0;  // of the taker, divided by the threads that it ran in
    bool stopped = false;     // given up by RunControl::stop
};

/// Units that are to be rendered.
struct UnitWork {
    const std::vector<UnitPixels>& units;    // all of a window
    const std::vector<std::size_t>& wanted;  // of them, by number
    const TakeUnit& take;                    // gets each when it is done
};

/// How that went. `stopped`: it was given up; units that were taken are complete.
struct UnitsRun {
    double render_seconds = 0;  // of the rays
    bool stopped = false;       // given up by RunControl::stop
};

/// A scene in an engine's own form. It is loaded once and run for a window at a time, so that a
/// picture in bands is not laid out again for each of them.
class LoadedScene {
  public:
    LoadedScene() = default;
    LoadedScene(const LoadedScene&) = delete;
    LoadedScene& operator=(const LoadedScene&) = delete;
    virtual ~LoadedScene() = default;

    /// Renders a window of the image. Precondition: it lies in the image. Throws Error: a bank of
    /// the machine is too small (5). What a thread throws is thrown again when all have ended.
    [[nodiscard]] virtual EngineResult run(const CropWindow& window, const RunControl& control,
                                           const BlockTaker* taker) = 0;
    [[nodiscard]] EngineResult run(const CropWindow& window, const RunControl& control) {
        return run(window, control, nullptr);
    }  // the result has the frame

    /// How this engine cuts a window into units.
    [[nodiscard]] virtual UnitGrid grid(const CropWindow& window) const = 0;
    /// Renders units of grid(window), each as run(window) would. Throws as run() does, and what
    /// `work.take` throws.
    [[nodiscard]] virtual UnitsRun run_units(const UnitGrid& grid, const UnitWork& work,
                                             const RunControl& control) = 0;
    /// What of the machine's statistics is known before a run: costs and memories.
    [[nodiscard]] virtual std::optional<MachineStatistics> machine() const { return std::nullopt; }

    /// The scene as words for nodes (dsp_kernels/scene_block.hpp).
    [[nodiscard]] const std::vector<std::uint32_t>& block() const { return block_; }

  protected:
    std::vector<std::uint32_t> block_;  // set by whoever derives from this
};

// Each of these keeps a reference to `scene`, which must outlive what is returned.

/// Broadcasts the scene to the nodes of a simulated machine; each run() is of a fresh machine.
/// Throws Error: a bank is too small (5).
[[nodiscard]] std::unique_ptr<LoadedScene> load_machine(const CompiledScene& scene,
                                                        const EngineChoice& choice);

/// The same with the node program in DSP32 code. Throws Error: the program does not know what the
/// scene needs (3), or a bank is too small (5); as its runs do, if a ray needs more than 256 cells.
[[nodiscard]] std::unique_ptr<LoadedScene> load_assembled_machine(const CompiledScene& scene,
                                                                  const EngineChoice& choice);

/// The node program on the cores at hand: 8x8 tiles (one pixel of each of the 64 nodes).
[[nodiscard]] std::unique_ptr<LoadedScene> load_reference(const CompiledScene& scene,
                                                          const EngineChoice& choice);

/// The whole crop window, loaded for this one run.
[[nodiscard]] EngineResult run_on_machine(const CompiledScene& scene, const EngineChoice& choice,
                                          const RunControl& control);
/// By load_reference().
[[nodiscard]] EngineResult run_reference(const CompiledScene& scene, const EngineChoice& choice,
                                         const RunControl& control);

/// One pixel with everything that happened to cells on its ray, as text (`--pixel x,y`).
[[nodiscard]] std::string describe_pixel(const CompiledScene& scene, Numeric numeric, long x,
                                         long y);

}  // namespace pxm::host
