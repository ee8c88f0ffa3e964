// A node of the machine that runs the node program in DSP32 code, and what the emulator sees of it:
// side channels, which take no time and no memory of the node.
#pragma once

#include <array>
#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/engine/frame.hpp"
#include "host/engine/statistics.hpp"
#include "host/engine/units.hpp"
#include "host/node_program/assembled_program.hpp"
#include "pxm/dsp32/processor/processor.hpp"

namespace pxm::host {

/// Where the program stopped.
enum class NodeEvent {
    working,    // within a pixel
    pixel,      // a pixel is in the front buffer
    done,       // all of them are
    heap_full,  // a ray needs more cells than the heap holds
    word_full,  // a ray leads to a word of more maps than a cell has room for
    broken,     // an access that left the memory, or a word that is no instruction
};

class AssembledNode {
  public:
    /// Loads the program and tells it which pixels are its. Preconditions: the scene is in the back
    /// buffer, the frame is open, the unit has pixels, node and scene outlive this.
    AssembledNode(dsp32::processor::ProcessorNode& node, const CompiledScene& scene,
                  const Model& model, const UnitPixels& unit);

    /// Executes so many instructions, at most to the end of a sample or pixel.
    NodeEvent go_on(std::uint64_t instructions = 1'000'000);

    /// The pixel that is in the front buffer now; adds what it took to `counts`.
    void take(PixelRecord& record, RayStatistics& counts);

    [[nodiscard]] std::uint64_t cycles() const { return processor_.cycles(); }
    [[nodiscard]] std::uint64_t cycles_since_pixel() const { return cycles() - cycles_before_; }
    [[nodiscard]] std::uint64_t instructions() const { return processor_.instructions(); }
    /// The instruction that is next.
    [[nodiscard]] std::uint32_t program_counter() const { return processor_.program_counter(); }
    /// Reads that came before their values were there: a mistake of the program.
    [[nodiscard]] const dsp32::processor::StaleReads& stale_reads() const {
        return processor_.stale_reads();
    }
    [[nodiscard]] const dsp32::processor::Stop& stop() const { return stop_; }

  private:
    /// What is known of a pixel's first ray, and of all of them together.
    struct Seen {
        bool first = true;
        bool hit = false;
        float z = 0;
        std::array<float, 3> normal{};
        std::int32_t level = 0;
        std::uint32_t word = 0;
        std::uint32_t volumes = 0;
        std::uint32_t capped = 0;
    };

    void look_at_sample();
    [[nodiscard]] std::uint32_t word_hash(std::uint32_t level);
    void set_half(std::string_view label, long value);
    [[nodiscard]] dsp32::Word word_at(std::string_view label, std::uint32_t index = 0);
    [[nodiscard]] float number_at(std::string_view label, std::uint32_t index = 0);

    const CompiledScene& scene_;
    const AssembledProgram& program_;
    dsp32::processor::Processor processor_;
    std::array<std::uint32_t, 4> stops_;  // labels that stand for the first events
    dsp32::processor::Stop stop_;
    Seen seen_;
    std::uint64_t cycles_before_ = 0;
};

}  // namespace pxm::host
