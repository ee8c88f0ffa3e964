// Programs of random instructions on a node with a little memory: whatever they do, they do it to
// their node.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <vector>

#include "pxm/dsp32/isa/instruction.hpp"
#include "pxm/dsp32/processor/processor.hpp"

namespace pxm::dsp32::processor {

/// What a program is made of: any words that have a format, or instructions that do not touch
/// memory.
enum class Mixture { any, calm };

inline Word random_word(std::mt19937_64& engine, Mixture mixture) {
    constexpr std::uint64_t first_dsp32 = 19;  // formats
    constexpr std::uint64_t first_control = 11, control = 6;
    const std::uint64_t bits = engine();
    const std::uint64_t number = mixture == Mixture::any ? (bits >> 32U) % first_dsp32
                                                         : first_control + (bits >> 32U) % control;
    const isa::Format& format = isa::formats()[number];
    const Word word = (static_cast<Word>(bits) & ~format.fixed_mask) | format.fixed_bits;
    if (format.operation != isa::Operation::branch || bits >> 60U == 0) return word;
    return (word & 0xFFE0'0000U) | static_cast<Word>(bits % 200 * 4);  // into the program
}

inline std::vector<Word> random_program(std::mt19937_64& engine, Mixture mixture) {
    std::vector<Word> words(200);
    for (Word& word : words) {
        do {
            word = random_word(engine, mixture);
        } while (mixture == Mixture::calm && !isa::decode(word, isa::Dialect::dsp32));
    }
    return words;
}

/// A node that is about to execute a random program, the same for the same state of the engine.
struct RandomRun {
    RandomRun(std::mt19937_64& engine, Mixture mixture) : node({}, 0), processor(node) {
        EXPECT_TRUE(node.back_buffer().reserve(100));
        EXPECT_TRUE(node.texture().reserve(5000));
        EXPECT_FALSE(processor.load(random_program(engine, mixture)));
        processor.start(0);
        for (unsigned r = 1; r < 14; ++r)
            processor.set_register(r, static_cast<std::uint16_t>(engine() % 0x9000 / 4 * 4));
    }
    ProcessorNode node;
    Processor processor;
};

/// How many programs stopped for which reason.
using StopCounts = std::array<int, 8>;

inline StopCounts try_random_programs(std::uint64_t seed, int count) {
    constexpr std::uint64_t most_steps = 5'000;
    std::mt19937_64 engine(seed);
    StopCounts stops{};
    for (int i = 0; i < count; ++i) {
        RandomRun run(engine, Mixture::any);
        const Stop stop = run.processor.run(most_steps);
        ++stops[static_cast<std::size_t>(stop.reason)];
        EXPECT_EQ(stop.fault.has_value(),
                  stop.reason == StopReason::fault || stop.reason == StopReason::misaligned);
        if (stop.fault) {
            EXPECT_FALSE(stop.fault->bank.empty());
        }
        EXPECT_LE(run.processor.instructions(), most_steps);
        EXPECT_EQ(run.node.back_buffer().used_bytes(), 100);
        EXPECT_EQ(run.node.front_buffer().used_bytes(), 0);
    }
    return stops;
}

/// Runs programs to breakpoints, and twins of them one instruction at a time; how many breakpoints
/// were met.
inline int try_breakpoints(std::uint64_t seed, int count) {
    constexpr int most_steps = 500;
    std::mt19937_64 engine(seed);
    int met = 0;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        std::mt19937_64 same = engine;
        RandomRun whole(engine, Mixture::calm), steps(same, Mixture::calm);
        const std::array<std::uint32_t, 2> breakpoints{
            static_cast<std::uint32_t>(engine() % 40 * 4),
            static_cast<std::uint32_t>(engine() % 200 * 4)};
        const Stop stop = whole.processor.run(most_steps, breakpoints);
        Stop step{StopReason::steps_used, 0, 0, {}};
        for (int k = 0; k < most_steps && step.reason == StopReason::steps_used; ++k) {
            const std::uint32_t at = steps.processor.program_counter();
            if (k > 0 && std::ranges::find(breakpoints, at) != breakpoints.end()) {
                step = {StopReason::breakpoint, at, 0, {}};
            } else {
                step = steps.processor.run(1);
            }
        }
        // A result on its way may leave the memory in front of a breakpoint.
        if (stop.reason == StopReason::fault && step.reason == StopReason::breakpoint)
            step = steps.processor.run(1);
        EXPECT_EQ(stop.reason, step.reason) << i;
        EXPECT_EQ(whole.processor.program_counter(), steps.processor.program_counter()) << i;
        EXPECT_EQ(whole.processor.instructions(), steps.processor.instructions()) << i;
        EXPECT_EQ(whole.processor.cycles(), steps.processor.cycles()) << i;
        met += stop.reason == StopReason::breakpoint ? 1 : 0;
        // And from there on.
        if (stop.reason != StopReason::breakpoint) continue;
        const Stop next = whole.processor.run(most_steps);
        const Stop other = steps.processor.run(most_steps);
        EXPECT_EQ(next.reason, other.reason) << i;
        EXPECT_EQ(whole.processor.instructions(), steps.processor.instructions()) << i;
    }
    return met;
}

}  // namespace pxm::dsp32::processor
