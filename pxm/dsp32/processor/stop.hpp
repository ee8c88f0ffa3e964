// Why a processor stopped, and what it read too early.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "pxm/fault.hpp"

namespace pxm::dsp32::processor {

enum class StopReason : std::uint8_t {  // why a processor stopped
    ended,                              // returned to return_address
    steps_used,                         // the limit of steps was reached
    breakpoint,                         // in front of an instruction with one
    fault,                              // an access outside the memory that is there
    misaligned,                         // an access at no multiple of its width
    illegal,                            // a word that is no instruction of the first DSP32
    not_modelled,                       // an instruction that needs a port, or companded numbers
};

/// As a message says it.
[[nodiscard]] constexpr std::string_view text_of(StopReason reason) noexcept {
    switch (reason) {
        case StopReason::ended:
            return "ended";
        case StopReason::steps_used:
            return "used all its steps";
        case StopReason::breakpoint:
            return "is at a breakpoint";
        case StopReason::fault:
            return "left the node's memory";
        case StopReason::misaligned:
            return "took a word that is not aligned";
        case StopReason::illegal:
            return "met a word that is no instruction of the DSP32";
        case StopReason::not_modelled:
            return "met an instruction that is not modelled";
    }
    return "";
}

struct Stop {                               // how a run ended
    StopReason reason = StopReason::ended;  // why
    std::uint32_t instruction_address = 0;  // of the instruction that it stopped at
    std::uint32_t access_address = 0;       // of a fault, or of what is misaligned
    std::optional<Fault> fault;             // with the bank
};

/// What can be read before it has its new value.
enum class StaleKind : std::uint8_t { accumulator, condition, memory, loaded_register };

/// Reads that got an old value because of the pipeline: a program may mean it, or not.
struct StaleReads {
    std::uint64_t count = 0;                        // how many
    std::uint32_t first_address = 0;                // of the instruction that read
    StaleKind first_kind = StaleKind::accumulator;  // of the first
};

}  // namespace pxm::dsp32::processor
