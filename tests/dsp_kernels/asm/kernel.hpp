// A kernel in assembler on a node of its own, with its arguments in fast memory.
#pragma once

#include <filesystem>
#include <initializer_list>

#include "tests/pxm/dsp32/processor/program.hpp"
#include "tests/pxm/dsp32/random_words.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

namespace pxm::kernels {

using dsp32::Float;
using dsp32::Word;
using dsp32::processor::ProcessorNode;
using dsp32::processor::Program;

inline std::string text_of_kernel(const char* name) {
    return test::text_of(std::filesystem::path(test::source_dir) / "dsp_kernels/asm" /
                         (std::string(name) + ".s"));
}

/// The sources of dsp_kernels/asm, and words for arguments behind the label `arguments`.
inline std::string kernels(std::initializer_list<const char*> names) {
    std::string source;
    for (const char* name : names) source += text_of_kernel(name);
    return source + "\n.data\narguments: 64*.word 0\n";
}

/// The fewest and the most of several runs.
struct Cycles {
    std::uint64_t fewest = ~std::uint64_t{0};
    std::uint64_t most = 0;

    void add(std::uint64_t cycles) {
        fewest = std::min(fewest, cycles);
        most = std::max(most, cycles);
    }
    [[nodiscard]] std::string text() const {
        const std::string end = std::to_string(most);
        return fewest == most ? end : std::to_string(fewest) + " to " + end;
    }
};

/// Words of instructions that a kernel's source makes, without those of the kernels it needs;
/// before it stands `names`, which has no instructions.
inline std::size_t words_of(const char* kernel, std::initializer_list<const char*> needs,
                            const std::string& names = "") {
    std::string source = names + text_of_kernel(kernel);
    for (const char* label : needs) source += std::string(".text\n") + label + ": nop\n";
    return dsp32::assembler::assemble(source, dsp32::isa::Dialect::dsp32).object.text.size() -
           needs.size();
}

/// Expects that docs/dsp32.md has a row of its table of kernels that starts like this.
inline void expect_row(const std::string& kernel, std::size_t words, const Cycles& cycles) {
    const std::string row =
        "| `" + kernel + "` | " + std::to_string(words) + " | " + cycles.text() + " | ";
    const auto document = std::filesystem::path(test::source_dir) / "docs/dsp32.md";
    EXPECT_NE(test::text_of(document).find(row), std::string::npos) << row;
}

/// A routine with its arguments in fast memory.
class Kernel {
  public:
    /// `more`: source behind that of the files.
    Kernel(std::string label, std::initializer_list<const char*> names,
           const std::string& more = "")
        : program(kernels(names) + ".text\n" + more),
          label_(std::move(label)),
          arguments_(program.at("arguments")) {}

    /// Puts words from a place on.
    void put(std::uint32_t place, std::initializer_list<Word> words) {
        for (const Word word : words) program.processor.fast_word(arguments_ + 4 * place++) = word;
    }
    [[nodiscard]] Word at(std::uint32_t place) {
        return program.processor.fast_word(arguments_ + 4 * place);
    }
    /// Calls it with r1, r2, ... pointing at these places.
    void call(std::initializer_list<std::uint32_t> places) {
        unsigned code = 1;
        for (const std::uint32_t place : places)
            program.processor.set_register(code++,
                                           static_cast<std::uint16_t>(arguments_ + 4 * place));
        call_label(label_, cycles);
    }
    void call_label(const std::string& label, Cycles& counted) {
        const std::uint64_t before = program.processor.cycles();
        program.call(label);
        counted.add(program.processor.cycles() - before);
        EXPECT_EQ(program.processor.stale_reads().count, 0U)
            << "at " << program.processor.stale_reads().first_address;
    }
    Program program;
    Cycles cycles;

  private:
    std::string label_;
    std::uint32_t arguments_;
};

/// A number near one, as coordinates are; or one of any size.
inline Word coordinate(dsp32::RandomWords& words) {
    const Word word = words();
    return (word & 0xFFU) == 0 ? dsp32::zero : word;
}

/// Any fraction and an exponent from 2^-32 to 2^31: no difference underflows of what a kernel
/// makes of such numbers, so that a comparison is what a subtraction says (docs/arithmetic.md).
inline Word ordinary(dsp32::RandomWords& words) {
    const Word word = words();
    if ((word & 0xFFU) == 0) return dsp32::zero;
    return (word & 0xFFFFFF00U) | std::clamp<Word>(word & 0xFFU, 96, 159);
}

}  // namespace pxm::kernels
