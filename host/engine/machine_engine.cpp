// The machine engine: load and broadcast, run the node program on every node, gather.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "host/engine/engine.hpp"
#include "host/engine/gather.hpp"
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

/// Costs and memories.
template <class Real>
MachineStatistics describe(Machine<Real>& machine, const CostModel& costs) {
    MachineStatistics statistics;
    statistics.costs = costs;
    const auto use = [](MemoryUse& memory, const Bank& bank) {
        memory.limit_bytes = bank.limit_bytes();
        memory.used_bytes = std::max(memory.used_bytes, bank.used_bytes());
    };
    for (Node<Real>& node : machine.nodes()) {
        use(statistics.fast_memory, node.fast_memory());
        use(statistics.front_buffer, node.front_buffer());
        use(statistics.back_buffer, node.back_buffer());
        use(statistics.zbuffer, node.zbuffer());
        use(statistics.texture, node.texture());
    }
    return statistics;
}

template <class Real>
MachineStatistics collect(Machine<Real>& machine, const std::vector<RayStatistics>& rays,
                          const CostModel& costs) {
    MachineStatistics statistics = describe(machine, costs);
    for (const Node<Real>& node : machine.nodes()) {
        statistics.tally.add(node.tally());
        statistics.nodes.push_back(
            statistics_of(node, rays[static_cast<std::size_t>(node.index())], costs));
    }
    return statistics;
}

/// Which units are wanted of a run, and how many pixels they have.
struct WantedUnits {
    std::vector<bool> units;
    std::size_t pixels = 0;

    WantedUnits(const UnitWork& work, std::size_t count) : units(count) {
        for (const std::size_t index : work.wanted) {
            units[index] = true;
            pixels += work.units[index].count();
        }
    }
};

template <class Real, kernels::Features features>
class LoadedMachine : public LoadedScene {
  public:
    LoadedMachine(const CompiledScene& scene, const EngineChoice& choice)
        : scene_(scene), choice_(choice) {
        block_ = make_scene_block<Real>(scene);
        machine_.emplace(loaded_machine());
    }

    using LoadedScene::run;
    EngineResult run(const CropWindow& window, const RunControl& control,
                     const BlockTaker* taker) override {
        const std::vector<UnitPixels> units = units_of(grid(window));
        std::vector<std::size_t> all(units.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        EngineResult result = run_nodes(window, {units, all, nullptr}, control);
        if (!taker) return result;
        // Of a run that was stopped, too: what the nodes have by then is a partial picture.
        PhaseClock clock;
        taker->take(result.frame);
        result.frame = {};
        result.take_seconds = clock.lap();
        return result;
    }

    [[nodiscard]] UnitGrid grid(const CropWindow& window) const override {
        return {window, 0, 0, choice_.machine->columns, choice_.machine->rows};
    }

    UnitsRun run_units(const UnitGrid& grid, const UnitWork& work,
                       const RunControl& control) override {
        const EngineResult result = run_nodes(grid.window, work, control);
        return {result.render_seconds, result.stopped};
    }

    [[nodiscard]] std::optional<MachineStatistics> machine() const override {
        Machine<Real> machine = loaded_machine();
        return describe(machine, choice_.costs);
    }

  private:
    /// Now and then.
    static void tell_progress(const RunControl& control, std::size_t done, std::size_t all) {
        if (control.progress && done % 256 == 0)
            control.progress(static_cast<double>(done) / static_cast<double>(all));
    }

    /// Renders the pixels of the nodes that are wanted, and gives each node to `work.take`, if
    /// there is one, when it is done.
    EngineResult run_nodes(const CropWindow& window, const UnitWork& work,
                           const RunControl& control) {
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

    const CompiledScene& scene_;
    EngineChoice choice_;
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
