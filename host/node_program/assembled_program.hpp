// The node program in DSP32 code: the sources of dsp_kernels/asm, assembled, and which scenes it
// knows (docs/dsp32.md, "The node program").
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/node_program/link.hpp"
#include "pxm/dsp32/assembler/assembler.hpp"
#include "pxm/dsp32/assembler/object.hpp"

namespace pxm::host {

/// A file of dsp_kernels/asm, without its ending.
struct AssemblerSource {
    std::string_view name;
    std::string_view text;
};

/// Those that node programs are made of, in the order in which they lie in memory.
[[nodiscard]] std::span<const AssemblerSource> assembler_sources();

class AssembledProgram {
  public:
    /// With the sources that such volumes need. Precondition: spheres, or boxes in axes.
    explicit AssembledProgram(kernels::Volume volume);

    /// Instructions, then data, as they lie in fast memory from address 0 on.
    [[nodiscard]] const std::vector<dsp32::Word>& words() const { return words_; }
    /// Precondition: a label of the sources.
    [[nodiscard]] std::uint32_t address_of(std::string_view label) const;
    /// The source that the instruction at that address is of; empty if there is none.
    [[nodiscard]] std::string_view source_of(std::uint32_t address) const;
    /// What each source takes of fast memory.
    [[nodiscard]] const NodeProgram& sizes() const { return sizes_; }

  private:
    /// Where the instructions of a source end.
    struct End {
        std::uint32_t address;
        std::string_view source;
    };

    void add_source(std::string_view name, std::span<const dsp32::assembler::Placed> placed,
                    int first_line, int end_line);

    dsp32::assembler::Object object_;
    std::vector<End> ends_;
    std::vector<dsp32::Word> words_;
    NodeProgram sizes_;
};

/// The program for a scene's first object, assembled once for its kind of volume; for balls where
/// it has none of which there is a program.
[[nodiscard]] const AssembledProgram& assembled_program(const CompiledScene& scene);

/// The first thing that the scene has and the program does not know, as the end of a sentence;
/// empty if there is none. `block_words`: of its scene block.
[[nodiscard]] std::string beyond_assembled_program(const CompiledScene& scene, Numeric numeric,
                                                   std::size_t block_words);

}  // namespace pxm::host
