// The machine engine with the node program in DSP32 code: load and broadcast, run the processor of
// every node, gather.
#include <fmt/format.h>

#include <atomic>
#include <optional>

#include "host/engine/assembled_node.hpp"
#include "host/engine/engine.hpp"
#include "host/engine/loaded_nodes.hpp"
#include "host/engine/node_records.hpp"
#include "host/engine/node_watch.hpp"
#include "host/engine/overflow.hpp"
#include "host/error.hpp"
#include "host/node_program/assembled_program.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "host/process/phase_clock.hpp"
#include "pxm/machine.hpp"

namespace pxm::host {

namespace {

using DspMachine = Machine<dsp32::Float>;
using DspNode = Node<dsp32::Float>;

void require_known(const CompiledScene& scene, Numeric numeric, std::size_t block_words) {
    const std::string beyond = beyond_assembled_program(scene, numeric, block_words);
    if (beyond.empty()) return;
    throw Error(ErrorKind::scene,
                "--program asm: the scene has " + beyond +
                    "; what the program knows: docs/dsp32.md, \"The node program\"");
}

/// What stopped a node, for the user; empty if nothing did.
std::string why_stopped(NodeEvent event, const AssembledNode& node, int index, long x, long y) {
    switch (event) {
        case NodeEvent::heap_full:
            return fmt::format(
                "node {}: a ray of pixel {},{} needs more than the 256 cells of the "
                "heap (--program asm has no other way to go on)",
                index, x, y);
        case NodeEvent::word_full:
            return fmt::format(
                "node {}: a ray of pixel {},{} leads to a word of more than the 200 "
                "maps that --program asm has room for",
                index, x, y);
        case NodeEvent::broken:
            return fmt::format("node {}: the program {} at {:04x} in pixel {},{}", index,
                               dsp32::processor::text_of(node.stop().reason),
                               node.stop().instruction_address, x, y);
        default:
            return {};
    }
}

class AssembledMachine : public LoadedNodes {
  public:
    AssembledMachine(const CompiledScene& scene, const EngineChoice& choice)
        : LoadedNodes(scene, choice) {
        block_ = make_scene_block<dsp32::Float>(scene);
        require_known(scene, choice.numeric, block_.size());
        machine_.emplace(loaded_machine());
    }

    [[nodiscard]] std::optional<MachineStatistics> machine() const override {
        DspMachine machine = loaded_machine();
        return describe(machine);
    }

  private:
    /// What all nodes of a run share.
    struct Run {
        const UnitWork& work;
        const RunControl& control;
        EngineResult& result;
        std::vector<NodeStatistics> nodes;
        std::vector<std::string> stops;  // why a node stopped, by node
        const WantedUnits wanted;
        NodeWatch* const watch;
        std::atomic<std::size_t> pixels_done = 0;
        std::atomic<bool> stopped = false;
    };

    EngineResult run_nodes(const CropWindow& window, const UnitWork& work,
                           const RunControl& control) override {
        DspMachine machine = machine_ ? std::move(*machine_) : loaded_machine();
        machine_.reset();
        PhaseClock clock;
        EngineResult result;
        result.frame = Frame(scene_.size, window);
        const std::size_t count = machine.nodes().size();
        Run run{work,
                control,
                result,
                std::vector<NodeStatistics>(count),
                std::vector<std::string>(count),
                WantedUnits(work, count),
                NodeWatch::laid()};
        refuse(machine.run([&](DspNode& node) { run_node(node, run); }, choice_.threads),
               *choice_.machine);
        for (const std::string& why : run.stops)
            if (!why.empty()) throw Error(ErrorKind::machine_limit, why);
        result.machine = describe(machine);
        for (const NodeStatistics& node : run.nodes) result.rays.add(node.rays);
        result.machine->nodes = std::move(run.nodes);
        result.stopped = run.stopped;
        result.render_seconds = clock.lap();
        return result;
    }

    void run_node(DspNode& node, Run& run) const {
        clear_overflow();  // a thread begins with the flags of whoever started it
        const auto index = static_cast<std::size_t>(node.index());
        NodeStatistics& own = run.nodes[index];
        own.id = node.index();
        own.column = node.id().column;
        own.row = node.id().row;
        if (!run.wanted.units[index] || run.stopped) return;
        const UnitPixels& unit = run.work.units[index];
        if (unit.count() > 0 && !render_unit(node, unit, run)) return;
        if (!run.work.take) return;
        std::vector<PixelRecord> records = records_of(run.result.frame, unit);
        run.work.take({index, records, own.rays, &own});
    }

    /// False if it did not come to its end.
    bool render_unit(DspNode& node, const UnitPixels& unit, Run& run) const {
        const auto index = static_cast<std::size_t>(node.index());
        NodeStatistics& own = run.nodes[index];
        AssembledNode program(node, scene_, *choice_.machine, unit);
        long x = unit.x0, y = unit.y0;
        NodeEvent event = NodeEvent::working;
        PixelRecord* last = nullptr;
        while (event == NodeEvent::working || event == NodeEvent::pixel) {
            if ((run.control.stop && *run.control.stop) || run.stopped) {
                run.stopped = true;
                break;
            }
            event = program.go_on();
            if (event != NodeEvent::pixel) continue;
            last = &run.result.frame.at(x, y);
            program.take(*last, own.rays);
            last->node = static_cast<std::uint16_t>(node.index());
            x += unit.step_x;
            if (x >= unit.x1) {
                x = unit.x0;
                y += unit.step_y;
            }
            if (run.watch != nullptr) run.watch->tell(index, program.cycles());
            tell_progress(run.control, ++run.pixels_done, run.wanted.pixels);
        }
        own.instructions = program.instructions();
        own.cycles = program.cycles();
        if (event != NodeEvent::done) {
            run.stops[index] = why_stopped(event, program, node.index(), x, y);
            run.stopped = true;
            return false;
        }
        // A pixel's cycles are those since the pixel before; the last one has the end, too.
        last->cycles += program.cycles_since_pixel();
        return true;
    }

    /// The memories; operations are not counted here, cycles are the processors' own.
    [[nodiscard]] MachineStatistics describe(DspMachine& machine) const {
        MachineStatistics statistics = describe_machine(machine, choice_.costs);
        const std::size_t words = assembled_program(scene_).words().size();
        statistics.fast_memory = {fast_memory_bytes,
                                  static_cast<std::int64_t>(words * sizeof(dsp32::Word))};
        return statistics;
    }

    [[nodiscard]] DspMachine loaded_machine() const {
        const Model& model = *choice_.machine;
        DspMachine machine(model);
        refuse(machine.open_frame(static_cast<int>(scene_.size.columns),
                                  static_cast<int>(scene_.size.rows)),
               model);
        refuse(machine.broadcast(block_), model);
        return machine;
    }

    std::optional<DspMachine> machine_;
};

}  // namespace

std::unique_ptr<LoadedScene> load_assembled_machine(const CompiledScene& scene,
                                                    const EngineChoice& choice) {
    return std::unique_ptr<LoadedScene>(new AssembledMachine(scene, choice));
}

}  // namespace pxm::host
