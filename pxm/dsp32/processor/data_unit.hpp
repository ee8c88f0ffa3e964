// The accumulators with their pipeline: what the multiplier and the conditions see of them late.
// Latencies [S7, S8]: an accumulator is seen by the multiplier three instructions after it was
// written, a condition four after; before that they see what was there before. The adder, and the
// conditional moves, see everything at once.
#pragma once

#include <array>

#include "pxm/dsp32/accumulator.hpp"

namespace pxm::dsp32::processor {

inline constexpr std::uint64_t multiplier_latency = 3;  // instructions
inline constexpr std::uint64_t condition_latency = 4;   // instructions

/// What the adder says of its result.
struct DataFlags {
    bool negative = false;   // below zero
    bool zero = true;        // zero
    bool overflow = false;   // above the range
    bool underflow = false;  // below the range
    bool operator==(const DataFlags&) const = default;
};

class DataUnit {  // the four accumulators and their flags
  public:
    /// As the adder sees it.
    [[nodiscard]] const Accumulator& value(std::size_t number) const noexcept {
        return states_[number].value;
    }
    /// As the multiplier sees it at instruction `now`; `stale` becomes true if that is no longer
    /// what the accumulator holds.
    [[nodiscard]] Word multiplier_input(std::size_t number, std::uint64_t now,
                                        bool& stale) const noexcept {
        const State& state = states_[number];
        if (now - state.written[0] >= multiplier_latency) [[likely]]
            return state.words[0];
        stale = true;
        return now - state.written[1] >= multiplier_latency ? state.words[1] : state.words[2];
    }
    /// Writes an accumulator at instruction `now`.
    void set(std::size_t number, Accumulator value, std::uint64_t now) noexcept {
        State& state = states_[number];
        state.value = value;
        state.words = {store(value), state.words[0], state.words[1]};
        state.written = {now, state.written[0]};
    }

    /// The flags of the last result.
    [[nodiscard]] DataFlags flags() const noexcept { return flags_; }
    /// As a branch sees them at instruction `now`; `stale` becomes true if there are later ones.
    [[nodiscard]] DataFlags condition_flags(std::uint64_t now, bool& stale) const noexcept {
        stale = stale || now - flagged_ < condition_latency;
        return past_flags_[(now - condition_latency) % past_flags_.size()];
    }
    /// Sets them at instruction `now`.
    void set_flags(DataFlags flags, std::uint64_t now) noexcept {
        flags_ = flags;
        flagged_ = now;
    }
    /// To be called at the end of every instruction.
    void remember_flags(std::uint64_t now) noexcept {
        past_flags_[now % past_flags_.size()] = flags_;
    }

  private:
    struct State {
        Accumulator value;
        std::array<Word, 3> words{};  // as the multiplier takes it: now, before, before that
        std::array<std::uint64_t, 2> written{};  // when the first two came
    };
    std::array<State, 4> states_;
    DataFlags flags_;
    std::uint64_t flagged_ = 0;
    std::array<DataFlags, 8> past_flags_;  // after each of the last instructions
};

}  // namespace pxm::dsp32::processor
