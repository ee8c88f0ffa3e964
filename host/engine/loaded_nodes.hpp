// What renders on the machine have in common, whatever their nodes execute: which nodes are wanted,
// windows and units, memories and progress.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "host/engine/engine.hpp"
#include "host/process/phase_clock.hpp"
#include "pxm/machine.hpp"

namespace pxm::host {

/// Costs, and of each memory the most that any node uses.
template <class Real>
[[nodiscard]] MachineStatistics describe_machine(Machine<Real>& machine, const CostModel& costs) {
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

/// Now and then.
inline void tell_progress(const RunControl& control, std::size_t done, std::size_t all) {
    constexpr std::size_t pixels_between = 256;
    if (control.progress && done % pixels_between == 0)
        control.progress(static_cast<double>(done) / static_cast<double>(all));
}

/// A scene on a machine. Who derives from it runs the nodes; a unit is what a node owns.
class LoadedNodes : public LoadedScene {
  public:
    using LoadedScene::run;
    EngineResult run(const CropWindow& window, const RunControl& control,
                     const BlockTaker* taker) final {
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

    [[nodiscard]] UnitGrid grid(const CropWindow& window) const final {
        return {window, 0, 0, choice_.machine->columns, choice_.machine->rows};
    }

    UnitsRun run_units(const UnitGrid& grid, const UnitWork& work,
                       const RunControl& control) final {
        const EngineResult result = run_nodes(grid.window, work, control);
        return {result.render_seconds, result.stopped};
    }

  protected:
    /// Precondition: the choice has a machine, and the scene outlives this.
    LoadedNodes(const CompiledScene& scene, const EngineChoice& choice)
        : scene_(scene), choice_(choice) {}

    /// Renders the pixels of the nodes that are wanted, and gives each node to `work.take`, if
    /// there is one, when it is done.
    virtual EngineResult run_nodes(const CropWindow& window, const UnitWork& work,
                                   const RunControl& control) = 0;

    const CompiledScene& scene_;
    EngineChoice choice_;
};

}  // namespace pxm::host
