// A kernel in assembler on a node of its own, with its arguments in fast memory.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <initializer_list>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

#include "pxm/dsp32/isa/names.hpp"
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

/// The registers and accumulators that the head of a kernel says it changes: "changes r1 to r7,
/// r15, a0 to a3"; what is no register of these ends or means memory.
inline std::set<std::string> changes_by_head(const std::string& source) {
    const std::string start = "//   changes ";
    const std::size_t at = source.find(start);
    EXPECT_NE(at, std::string::npos);
    const std::size_t from = at + start.size();
    std::istringstream words(source.substr(from, source.find_first_of(";\n", from) - from));
    std::set<std::string> names;
    if (words.str().starts_with("all registers")) {
        for (const std::string_view name : dsp32::isa::register_names) names.emplace(name);
        for (const char* name : {"a0", "a1", "a2", "a3"}) names.emplace(name);
        return names;
    }
    int last = 0;
    bool range = false;
    for (std::string word; words >> word;) {
        if (word == "to") {
            range = true;
        } else if (word.size() > 1 && std::isdigit(static_cast<unsigned char>(word[1])) != 0) {
            const int number = std::stoi(word.substr(1));
            for (int n = range ? last : number; n <= number; ++n)
                names.insert(word.substr(0, 1) + std::to_string(n));
            last = number;
            range = false;
        }
    }
    EXPECT_FALSE(names.empty());
    return names;
}

/// That of the files in which the label is defined.
inline std::string source_with(const std::string& label, std::initializer_list<const char*> names) {
    for (const char* name : names) {
        const std::string source = text_of_kernel(name);
        if (source.find("\n" + label + ":\n") != std::string::npos) return source;
    }
    ADD_FAILURE() << label;
    return {};
}

/// A routine with its arguments in fast memory. It is held to its head: registers and accumulators
/// that are not said to change keep their values; and its program stays as it was assembled.
class Kernel {
  public:
    /// `more`: source behind that of the files.
    Kernel(std::string label, std::initializer_list<const char*> names,
           const std::string& more = "")
        : program(kernels(names) + ".text\n" + more),
          changes_(changes_by_head(source_with(label, names))),
          label_(std::move(label)),
          arguments_(program.at("arguments")) {}
    Kernel(const Kernel&) = delete;
    Kernel& operator=(const Kernel&) = delete;
    ~Kernel() {
        std::uint32_t address = 0;
        for (const Word word : program.object().text) {
            EXPECT_EQ(program.processor.fast_word(address), word) << label_ << " at " << address;
            address += 4;
        }
    }

    /// Puts words from a place on.
    void put(std::uint32_t place, std::initializer_list<Word> words) {
        for (const Word word : words) program.processor.fast_word(arguments_ + 4 * place++) = word;
    }
    [[nodiscard]] Word at(std::uint32_t place) {
        return program.processor.fast_word(arguments_ + 4 * place);
    }
    /// Calls it with r1, r2, ... pointing at these places.
    void call(std::initializer_list<std::uint32_t> places) {
        for (unsigned code = 1; code < dsp32::isa::register_count; ++code)
            if (is_kept_by_head(code))
                program.processor.set_register(code, static_cast<std::uint16_t>(0x5A00 + code));
        unsigned code = 1;
        for (const std::uint32_t place : places)
            program.processor.set_register(code++,
                                           static_cast<std::uint16_t>(arguments_ + 4 * place));
        call_label(label_, cycles);
    }
    void call_label(const std::string& label, Cycles& counted) {
        const std::uint64_t before = program.processor.cycles();
        std::array<std::uint16_t, dsp32::isa::register_count> registers{};
        for (unsigned code = 1; code < registers.size(); ++code) registers[code] = program.r(code);
        const std::array<Word, 4> accumulators{program.a(0), program.a(1), program.a(2),
                                               program.a(3)};
        program.call(label);
        counted.add(program.processor.cycles() - before);
        for (unsigned code = 1; code < registers.size(); ++code) {
            if (is_kept_by_head(code)) {
                EXPECT_EQ(program.r(code), registers[code]) << name_of(code);
            }
        }
        for (std::size_t a = 0; a < accumulators.size(); ++a) {
            if (!changes_.contains("a" + std::to_string(a))) {
                EXPECT_EQ(program.a(a), accumulators[a]) << "a" << a;
            }
        }
        EXPECT_EQ(program.processor.stale_reads().count, 0U)
            << "at " << program.processor.stale_reads().first_address;
    }
    Program program;
    Cycles cycles;

  private:
    static std::string name_of(unsigned code) {
        return std::string(dsp32::isa::register_names[code]);
    }
    /// Of r1 to r21 but r14, which a call changes.
    [[nodiscard]] bool is_kept_by_head(unsigned code) const {
        const std::string name = name_of(code);
        return name.size() > 1 && name[0] == 'r' && name != "r14" && name != "r22" &&
               !changes_.contains(name);
    }

    std::set<std::string> changes_;
    std::string label_;
    std::uint32_t arguments_;
};

/// A node with so many words of a scene block, zeros at first, for the C++ of a kernel.
struct ShapedNode {
    explicit ShapedNode(std::uint32_t words) : node({}, 0) {
        EXPECT_TRUE(node.back_buffer().reserve(std::int64_t{4} * words));
        shape = node.back_buffer().words();
        std::ranges::fill(shape, dsp32::zero);
    }
    /// Puts the same words into another node's back buffer.
    void copy_to(ProcessorNode& other) const {
        if (other.back_buffer().used_bytes() == 0) {
            EXPECT_TRUE(other.back_buffer().reserve(static_cast<std::int64_t>(shape.size_bytes())));
        }
        std::ranges::copy(shape, other.back_buffer().words().begin());
    }
    ProcessorNode node;
    std::span<Word> shape;
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
