// The assembler: the text of a program to words, in two passes. The first lays out labels, the
// second makes words. The syntax is AT&T's as its library and programs show it [S9, S12]:
// docs/dsp32.md.
#pragma once

#include "pxm/dsp32/assembler/mistake.hpp"
#include "pxm/dsp32/assembler/object.hpp"

namespace pxm::dsp32::assembler {

/// Bytes that a line of the source left in memory.
struct Placed {
    std::uint32_t address = 0;  // of the first byte
    std::uint32_t bytes = 0;    // how many
    int line = 1;               // of the source, from 1
};

struct Assembly {                   // what became of a source
    Object object;                  // empty if there are mistakes, or if the program is too large
    std::vector<Mistake> mistakes;  // in the order in which they were found
    std::vector<Placed> placed;     // by line
    std::int64_t words = 0;         // that the program takes
    std::int64_t words_limit = 0;   // that the fast memory has
    /// Whether fast memory has too few words.
    [[nodiscard]] bool too_large() const { return words > words_limit; }
};

/// Assembles a source for a node's fast memory.
[[nodiscard]] Assembly assemble(std::string_view source, isa::Dialect dialect);

/// The source with addresses and words beside it.
[[nodiscard]] std::string listing(const Assembly& assembly, std::string_view source);

/// The word of one instruction that stands alone at an address, in a program of so many bytes.
[[nodiscard]] std::optional<Word> assemble_instruction(std::string_view text, std::uint32_t address,
                                                       std::uint32_t program_bytes,
                                                       isa::Dialect dialect);

}  // namespace pxm::dsp32::assembler
