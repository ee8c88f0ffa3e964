// The machine engine: load and broadcast, run the node program on every node, gather.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "host/engine/engine.hpp"
#include "host/engine/gather.hpp"
#include "host/error.hpp"
#include "host/node_program/instances.hpp"
#include "host/process/phase_clock.hpp"
#include "pxm/cost.hpp"
#include "pxm/machine.hpp"

namespace pxm::host {

namespace {

void refuse(const std::optional<Fault>& fault, const Model& model) {
    if (!fault) return;
    throw Error(
        ErrorKind::machine_limit,
        fmt::format("the {} of node {} of the {} is too small: {} bytes wanted, {} there",
                    fault->bank, fault->node, model.name, fault->wanted_bytes, fault->limit_bytes));
}

/// The first coordinate at or after `from` that is congruent to `place` modulo `stride`.
std::uint32_t first_owned(long from, int place, int stride) {
    const long behind = (from - place) % stride;
    return static_cast<std::uint32_t>(behind > 0   ? from + stride - behind
                                      : behind < 0 ? from - behind
                                                   : from);
}

kernels::PixelShare node_share(const CropWindow& window, const Model& model, NodeId id) {
    return {first_owned(window.x0, id.column, model.columns),
            first_owned(window.y0, id.row, model.rows),
            static_cast<std::uint32_t>(window.x1),
            static_cast<std::uint32_t>(window.y1),
            static_cast<std::uint32_t>(model.columns),
            static_cast<std::uint32_t>(model.rows)};
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
MachineStatistics collect(Machine<Real>& machine, const std::vector<RayStatistics>& rays,
                          const CostModel& costs) {
    MachineStatistics statistics;
    statistics.costs = costs;
    const auto use = [](MemoryUse& memory, const Bank& bank) {
        memory.limit_bytes = bank.limit_bytes();
        memory.used_bytes = std::max(memory.used_bytes, bank.used_bytes());
    };
    for (Node<Real>& node : machine.nodes()) {
        NodeStatistics one;
        one.id = node.index();
        one.column = node.id().column;
        one.row = node.id().row;
        one.rays = rays[static_cast<std::size_t>(node.index())];
        one.tally = node.tally();
        one.instructions = instructions(node.tally(), costs.table);
        one.cycles = cycles(node.tally(), costs.table);
        statistics.tally.add(node.tally());
        statistics.nodes.push_back(one);
        use(statistics.fast_memory, node.fast_memory());
        use(statistics.front_buffer, node.front_buffer());
        use(statistics.back_buffer, node.back_buffer());
        use(statistics.zbuffer, node.zbuffer());
        use(statistics.texture, node.texture());
    }
    return statistics;
}

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
        // Counts and memories are those of one run, so a further run is of another machine.
        Machine<Real> machine = machine_ ? std::move(*machine_) : loaded_machine();
        machine_.reset();
        PhaseClock clock;
        const Model& model = *choice_.machine;
        const int width = static_cast<int>(scene_.size.columns);
        EngineResult result;
        result.frame = Frame(scene_.size, window);
        std::vector<RayStatistics> rays(machine.nodes().size());
        std::atomic<std::size_t> done = 0;
        std::atomic<bool> stopped = false;
        const auto program = [&](Node<Real>& node) {
            clear_overflow();  // a thread begins with the flags of whoever started it
            RayStatistics& counts = rays[static_cast<std::size_t>(node.index())];
            const kernels::PixelShare share = node_share(window, model, node.id());
            if (share.x0 >= share.x1 || share.y0 >= share.y1) return;
            // A pixel's cycles are all that was counted since the pixel before, so they sum up to
            // the node's; the first pixel carries the start of the program.
            std::uint64_t cycles_before = 0;
            kernels::pixel_program<features>(
                node, share,
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
                    const std::size_t finished = ++done;
                    if (control.progress && finished % 256 == 0) {
                        control.progress(static_cast<double>(finished) /
                                         static_cast<double>(result.frame.pixels.size()));
                    }
                    if (control.stop && *control.stop) stopped = true;
                    return !stopped && !node.halted();
                });
        };
        refuse(machine.run(program, choice_.threads), model);
        for (const RayStatistics& counts : rays) result.rays.add(counts);
        result.machine = collect(machine, rays, choice_.costs);
        result.stopped = stopped;
        result.render_seconds = clock.lap();
        if (taker && !stopped) taker->take(std::exchange(result.frame, {}));
        result.take_seconds = clock.lap();
        return result;
    }

  private:
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
