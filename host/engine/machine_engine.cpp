// The machine engine: load and broadcast, run the node program on every node, gather.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "host/engine/engine.hpp"
#include "host/engine/gather.hpp"
#include "host/engine/loaded_nodes.hpp"
#include "host/engine/node_records.hpp"
#include "host/engine/node_watch.hpp"
#include "host/error.hpp"
#include "host/node_program/instances.hpp"
#include "host/process/phase_clock.hpp"
#include "pxm/cost.hpp"
#include "pxm/machine.hpp"

namespace pxm::host {

namespace {

kernels::PixelShare share_of(const UnitPixels& unit) {
    const auto word = [](long v) { return static_cast<std::uint32_t>(v); };
    return {word(unit.x0), word(unit.y0),     word(unit.x1),
            word(unit.y1), word(unit.step_x), word(unit.step_y)};
}

/// The display word: 8 bits each of red, green, blue, alpha, from linear values.
std::uint32_t pack_pixel(const PixelRecord& pixel) {
    const auto byte = [](float v) {
        return static_cast<std::uint32_t>(std::clamp(v, 0.0F, 1.0F) * 255.0F + 0.5F);
    };
    return byte(pixel.color[0]) << 24 | byte(pixel.color[1]) << 16 | byte(pixel.color[2]) << 8 |
           byte(pixel.alpha);
}

template <class Real>
NodeStatistics statistics_of(const Node<Real>& node, const RayStatistics& rays,
                             const CostModel& costs) {
    NodeStatistics one;
    one.id = node.index();
    one.column = node.id().column;
    one.row = node.id().row;
    one.rays = rays;
    one.tally = node.tally();
    one.instructions = instructions(node.tally(), costs.table);
    one.cycles = cycles(node.tally(), costs.table);
    return one;
}

template <class Real>
MachineStatistics collect(Machine<Real>& machine, const std::vector<RayStatistics>& rays,
                          const CostModel& costs) {
    MachineStatistics statistics = describe_machine(machine, costs);
    for (const Node<Real>& node : machine.nodes()) {
        statistics.tally.add(node.tally());
        statistics.nodes.push_back(
            statistics_of(node, rays[static_cast<std::size_t>(node.index())], costs));
    }
    return statistics;
}

template <class Real, kernels::Features features>
class LoadedMachine : public LoadedNodes {
  public:
    LoadedMachine(const CompiledScene& scene, const EngineChoice& choice)
        : LoadedNodes(scene, choice) {
        block_ = make_scene_block<Real>(scene);
        machine_.emplace(loaded_machine());
    }

    [[nodiscard]] std::optional<MachineStatistics> machine() const override {
        Machine<Real> machine = loaded_machine();
        return describe_machine(machine, choice_.costs);
    }

  private:
    EngineResult run_nodes(const CropWindow& window, const UnitWork& work,
                           const RunControl& control) override {
        // Counts and memories are those of one run, so a further run is of another machine.
        Machine<Real> machine = machine_ ? std::move(*machine_) : loaded_machine();
        machine_.reset();
        PhaseClock clock;
        const Model& model = *choice_.machine;
        const int width = static_cast<int>(scene_.size.columns);
        EngineResult result;
        result.frame = Frame(scene_.size, window);
        std::vector<RayStatistics> rays(machine.nodes().size());
        const WantedUnits wanted(work, machine.nodes().size());
        std::atomic<std::size_t> done = 0;
        std::atomic<bool> stopped = false;
        NodeWatch* const watch = NodeWatch::laid();
        const auto program = [&](Node<Real>& node) {
            clear_overflow();  // a thread begins with the flags of whoever started it
            const auto index = static_cast<std::size_t>(node.index());
            RayStatistics& counts = rays[index];
            if (!wanted.units[index] || stopped) return;
            const UnitPixels& unit = work.units[index];
            const auto give = [&] {
                if (!work.take || stopped || node.halted()) return;
                const NodeStatistics statistics = statistics_of(node, counts, choice_.costs);
                std::vector<PixelRecord> records = records_of(result.frame, unit);
                work.take({index, records, counts, &statistics});
            };
            if (unit.count() == 0) return give();
            // A pixel's cycles are all that was counted since the pixel before, so they sum up to
            // the node's; the first pixel carries the start of the program.
            std::uint64_t cycles_before = 0;
            kernels::pixel_program<features>(
                node, share_of(unit),
                [&](std::uint32_t x, std::uint32_t y, const kernels::PixelResult<Real>& pixel) {
                    PixelRecord& record = result.frame.at(x, y);
                    gather_pixel(scene_, block_, pixel, record, counts);
                    record.node = static_cast<std::uint16_t>(node.index());
                    node.write_pixel(
                        pixel_in_node(model, width, static_cast<int>(x), static_cast<int>(y)),
                        pack_pixel(record));
                    const std::uint64_t now = cycles(node.tally(), choice_.costs.table);
                    record.cycles = now - cycles_before;
                    cycles_before = now;
                    if (watch != nullptr) watch->tell(index, now);
                    tell_progress(control, ++done, wanted.pixels);
                    if (control.stop && *control.stop) stopped = true;
                    return !stopped && !node.halted();
                });
            give();
        };
        refuse(machine.run(program, choice_.threads), model);
        for (const RayStatistics& counts : rays) result.rays.add(counts);
        result.machine = collect(machine, rays, choice_.costs);
        result.stopped = stopped;
        result.render_seconds = clock.lap();
        return result;
    }

    [[nodiscard]] Machine<Real> loaded_machine() const {
        const Model& model = *choice_.machine;
        Machine<Real> machine(model);
        refuse(machine.open_frame(static_cast<int>(scene_.size.columns),
                                  static_cast<int>(scene_.size.rows)),
               model);
        refuse(machine.load_program(choice_.program_bytes, choice_.stack_bytes), model);
        refuse(machine.broadcast(block_), model);
        refuse(machine.broadcast_textures(scene_.texture_words), model);
        refuse(machine.reserve_heap(static_cast<int>(scene_.heap), sizeof(kernels::Cell<Real>)),
               model);
        return machine;
    }

    std::optional<Machine<Real>> machine_;
};

}  // namespace

std::unique_ptr<LoadedScene> load_machine(const CompiledScene& scene, const EngineChoice& choice) {
    return with_instance(scene, choice.numeric, [&]<class Real, kernels::Features features>() {
        return std::unique_ptr<LoadedScene>(new LoadedMachine<Real, features>(scene, choice));
    });
}

EngineResult run_on_machine(const CompiledScene& scene, const EngineChoice& choice,
                            const RunControl& control) {
    return load_machine(scene, choice)->run(scene.crop, control);
}

}  // namespace pxm::host
