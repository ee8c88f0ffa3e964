// A word as a line of the published assembler syntax.
#pragma once

#include <functional>
#include <string>

#include "pxm/dsp32/isa/instruction.hpp"

namespace pxm::dsp32::isa {

/// The name of an address, or empty if it has none.
using LabelOf = std::function<std::string(std::uint32_t address)>;

/// The instruction as text. It assembles to a word with the same text; where two words say the
/// same, not always to the same word (docs/dsp32.md).
[[nodiscard]] std::string text_of(const Instruction& instruction, Dialect dialect);

/// The word at `address` as text: a branch to an address that has a label shows it. A word that the
/// dialect does not have is shown as data: `.word 0x...`.
[[nodiscard]] std::string text_of(Word word, std::uint32_t address, Dialect dialect,
                                  const LabelOf& label_of);

/// Where a branch or call leads, if its word says so.
[[nodiscard]] std::optional<std::uint32_t> target_of(const Instruction& instruction,
                                                     std::uint32_t address, Dialect dialect);

}  // namespace pxm::dsp32::isa
