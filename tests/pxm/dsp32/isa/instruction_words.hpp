// Words to try the instruction set with: any bits, and bits that are an instruction's more often
// than not.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "pxm/dsp32/assembler/assembler.hpp"
#include "pxm/dsp32/isa/disassemble.hpp"

namespace pxm::dsp32::isa {

class InstructionWords {
  public:
    explicit InstructionWords(std::uint64_t seed) : engine_(seed) {}

    /// One in four is any word; the others have the fixed bits of some format.
    Word operator()() {
        const std::uint64_t bits = engine_();
        const auto word = static_cast<Word>(bits);
        if (bits >> 62U == 0) return word;
        const Format& format = formats()[(bits >> 32U) % formats().size()];
        return (word & ~format.fixed_mask) | format.fixed_bits;
    }

  private:
    std::mt19937_64 engine_;
};

/// Tries `count` words in both dialects: a word that is an instruction comes back from decoding,
/// and its text from assembling. Returns how many were instructions.
inline int try_words(std::uint64_t seed, int count) {
    InstructionWords words(seed);
    constexpr std::uint32_t address = 0x4000, program_bytes = 0x9000;
    int instructions = 0;
    for (int i = 0; i < count; ++i) {
        const Word word = words();
        for (const Dialect dialect : {Dialect::dsp32, Dialect::dsp32c}) {
            const auto instruction = decode(word, dialect);
            if (!instruction) continue;
            ++instructions;
            const Word again = encode(*instruction);
            if (again != word) ADD_FAILURE() << std::hex << word << " came back as " << again;
            const std::string text = text_of(*instruction, dialect);
            const auto to = target_of(*instruction, address, dialect);
            if (to && (*to >= program_bytes || *to % 4 != 0)) continue;  // an assembler refuses it
            const auto assembled =
                assembler::assemble_instruction(text, address, program_bytes, dialect);
            if (!assembled) {
                ADD_FAILURE() << text << " does not assemble, from " << std::hex << word;
                continue;
            }
            const auto read = decode(*assembled, dialect);
            if (!read || text_of(*read, dialect) != text)
                ADD_FAILURE() << text << " became " << std::hex << *assembled << ", from " << word;
            if (testing::Test::HasFailure() && i > 100) return instructions;
        }
    }
    return instructions;
}

}  // namespace pxm::dsp32::isa
