// Laws of the processor: its arithmetic is pxm/dsp32's, its pipeline the documented one, and no
// program leaves the node.
#include <random>

#include "pxm/dsp32/isa/disassemble.hpp"
#include "tests/pxm/dsp32/processor/program.hpp"
#include "tests/pxm/dsp32/processor/random_programs.hpp"
#include "tests/pxm/dsp32/random_words.hpp"

namespace pxm::dsp32::processor {
namespace {

const std::string ending = "nop\nnop\nnop\nreturn (r14)\nnop\n";

TEST(Processor, one_instruction_is_one_operation_of_the_accumulators) {
    Program p(
        "start: r1 = x\n a0 = *r1++\n r2 = y\n nop\n"
        "a1 = *r1 + *r2\n a2 = *r1 - *r2\n a3 = *r1 * *r2\n nop\n nop\n"
        "a1 = a0 + *r1 * *r2\n nop\n nop\n nop\n"
        "a2 = a0 - *r1 * *r2\n a3 = -*r2\n" +
        ending + ".data\nc: .word 0\nx: .word 0, 0\ny: .word 0\n");
    RandomWords words(11);
    for (int i = 0; i < 20'000; ++i) {
        const Word c = words(), x = words(), y = words();
        p.word("x") = c;
        p.word("x", 1) = x;
        p.word("y") = y;
        p.processor.start(0);
        ASSERT_EQ(p.processor.run(7).reason, StopReason::steps_used);
        EXPECT_EQ(p.processor.accumulator(0), load(store(load(c))));
        EXPECT_EQ(p.processor.accumulator(1), add(x, y));
        EXPECT_EQ(p.processor.accumulator(2), subtract(x, y));
        EXPECT_EQ(p.processor.accumulator(3), multiply(x, y));
        ASSERT_EQ(p.run().reason, StopReason::ended);
        EXPECT_EQ(p.processor.accumulator(1), multiply_add(load(c), x, y));
        EXPECT_EQ(p.processor.accumulator(2), multiply_subtract(load(c), x, y));
        EXPECT_EQ(p.processor.accumulator(3), negate(y));
    }
}

TEST(Processor, sums_keep_their_guard_bits_and_products_drop_those_of_their_factors) {
    Program p(
        "start: r1 = v\n r2 = v\n nop\n"
        "a0 = *r1++ * *r2++\n a0 = a0 + *r1++ * *r2++\n a0 = a0 + *r1++ * *r2++\n"
        "nop\n nop\n nop\n a1 = a0 * a0\n a2 = a0\n" +
        ending + ".data\nv: .word 0, 0, 0\n");
    RandomWords words(12);
    for (int i = 0; i < 20'000; ++i) {
        Accumulator sum;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Word x = words();
            p.word("v", k) = x;
            sum = k == 0 ? multiply(x, x) : multiply_add(sum, x, x);
        }
        p.call("start");
        EXPECT_EQ(p.processor.accumulator(0), sum);
        EXPECT_EQ(p.processor.accumulator(1), multiply(store(sum), store(sum)));
        EXPECT_EQ(p.processor.accumulator(2), sum);
    }
}

std::string idle(int instructions) {
    std::string text;
    for (int i = 0; i < instructions; ++i) text += "nop\n";
    return text;
}

TEST(Processor, the_multiplier_sees_an_accumulator_three_instructions_later) {
    for (int between = 0; between < 4; ++between) {
        Program p("start: r1 = v\n a0 = *r1++\n" + idle(3) + "a0 = *r1++\n" + idle(between) +
                  "a1 = a0 * *r1\n a2 = a0 + *r1\n" + ending + ".data\nv: float 2, 3, 10\n");
        p.call("start");
        EXPECT_EQ(p.a(1), word_of(between < 2 ? 20.0 : 30.0)) << between;
        EXPECT_EQ(p.a(2), word_of(13.0)) << "the adder sees it at once";
        EXPECT_EQ(p.processor.stale_reads().count, between < 2 ? 1U : 0U);
        if (between < 2) {
            EXPECT_EQ(p.processor.stale_reads().first_kind, StaleKind::accumulator);
            EXPECT_EQ(p.processor.stale_reads().first_address, (6U + between) * 4);
        }
    }
}

TEST(Processor, of_several_writes_the_multiplier_sees_the_last_that_is_old_enough) {
    Program p(
        "start: r1 = v\n a0 = *r1++\n nop\n nop\n a0 = *r1++\n a0 = *r1++\n a0 = *r1++\n"
        "a1 = a0 * *r1\n a2 = a0 * *r1\n a3 = a0 * *r1\n" +
        ending + ".data\nv: float 2, 3, 5, 7, 10\n");
    p.call("start");
    EXPECT_EQ(p.a(1), word_of(30.0));
    EXPECT_EQ(p.a(2), word_of(50.0));
    EXPECT_EQ(p.a(3), word_of(70.0));
    EXPECT_EQ(p.processor.stale_reads().count, 2U);
}

TEST(Processor, memory_holds_a_result_four_instructions_later) {
    for (int between = 0; between < 5; ++between) {
        Program p("start: r1 = v\n r2 = w\n *r2 = a0 = *r1\n" + idle(between) + "a1 = *r2\n" +
                  "r3 = *w\n" + ending + ".data\nv: float 2\nw: float 3\n");
        p.call("start");
        EXPECT_EQ(p.a(1), word_of(between < 3 ? 3.0 : 2.0)) << between;
        EXPECT_EQ(p.r(3), between < 2 ? 0x0080 | 1 : 0x0081) << "the lower half of 3 is that of 2";
        EXPECT_EQ(p.word("w"), word_of(2.0)) << "it is there when the program has ended";
        EXPECT_EQ(p.processor.stale_reads().count, between < 2 ? 2U : between < 3 ? 1U : 0U);
    }
}

TEST(Processor, a_branch_sees_a_condition_four_instructions_later_a_move_at_once) {
    for (int between = 0; between < 5; ++between) {
        Program p("start: r1 = v\n a0 = *r1++\n" + idle(4) + "a0 = -*r1\n a1 = ifalt(*r1)\n" +
                  idle(between) + "if (alt) goto less\n r2 = 1\n r2 = 2\nless:\n" + ending +
                  ".data\nv: float 2, 3\n");
        p.call("start");
        EXPECT_EQ(p.a(1), word_of(3.0));
        EXPECT_EQ(p.r(2), between < 2 ? 2 : 1) << between;
        EXPECT_EQ(p.processor.stale_reads().count, between < 2 ? 1U : 0U);
    }
}

TEST(Processor, a_loaded_register_has_its_value_after_the_next_instruction) {
    Program p("start: r1 = 5\n r1 = *v\n r2 = r1\n r3 = r1\n" + ending + ".data\nv: int 9, 0\n");
    p.call("start");
    EXPECT_EQ(p.r(2), 5);
    EXPECT_EQ(p.r(3), 9);
    EXPECT_EQ(p.processor.stale_reads().count, 1U);
    EXPECT_EQ(p.processor.stale_reads().first_kind, StaleKind::loaded_register);
    Program q("start: r4 = v\n r1 = *r4++\n r2 = *r4++\n r3 = r1 + 0\n r5 = r2 + 0\n" + ending +
              ".data\nv: int 9, 10\n");
    q.call("start");
    EXPECT_EQ(q.r(3), 9);
    EXPECT_EQ(q.r(5), 10);
    EXPECT_EQ(q.processor.stale_reads().count, 0U);
}

TEST(Processor, a_branch_executes_the_instruction_behind_it) {
    Program p("start: goto there\n r1 = 1\n r1 = 2\nthere: r2 = r1\n" + ending);
    p.call("start");
    EXPECT_EQ(p.r(2), 1);
    // Of two branches in a row both are taken: the second is the slot of the first.
    Program q("start: goto a\n goto b\n r1 = 1\na: r2 = 3\n r3 = 4\nb: r4 = 5\n" + ending);
    q.call("start");
    EXPECT_EQ(q.r(1), 0);
    EXPECT_EQ(q.r(2), 3);
    EXPECT_EQ(q.r(3), 0);
    EXPECT_EQ(q.r(4), 5);
}

TEST(Processor, a_call_returns_behind_its_slot_and_a_loop_turns_as_often_as_it_says) {
    Program p(
        "start: r13 = r14\n call sub (r14)\n r1 = r1 + 1\n r1 = r1 + 0x10\n"
        "r5 = 3\nloop: r2 = r2 + 1\n if (r5-- >= 0) goto loop\n nop\n"
        "return (r13)\n nop\nsub: return (r14)\n r1 = r1 + 0x100\n");
    p.call("start");
    EXPECT_EQ(p.r(1), 0x111);
    EXPECT_EQ(p.r(2), 5) << "once, and once for each of 3, 2, 1, 0";
    EXPECT_EQ(p.r(5), 0xFFFE);
}

TEST(Processor, integers_have_16_bits_and_the_flags_of_their_sums) {
    struct Case {
        const char* statement;
        std::uint16_t a, b, result;
        Flags flags;  // negative, zero, carry, overflow
    };
    const Case cases[] = {
        {"r1 = r1 + r2", 0x7FFF, 1, 0x8000, {true, false, false, true}},
        {"r1 = r1 + r2", 0xFFFF, 1, 0, {false, true, true, false}},
        {"r1 = r1 - r2", 0, 1, 0xFFFF, {true, false, true, false}},
        {"r1 = r1 - r2", 0x8000, 1, 0x7FFF, {false, false, false, true}},
        {"r1 = r2 - r1", 1, 3, 2, {false, false, false, false}},
        {"r1 - r2", 5, 5, 5, {false, true, false, false}},
        {"r1 = -r2", 0, 1, 0xFFFF, {true, false, true, false}},
        {"r1 = r2 * 2", 0, 0xC001, 0x8002, {true, false, true, false}},
        {"r1 = r2 / 2", 0, 0x8003, 0xC001, {true, false, true, false}},
        {"r1 = r2 >> 1", 0, 0x8002, 0x4001, {false, false, false, false}},
        {"r1 = r1 & r2", 0xF0F0, 0xFF00, 0xF000, {true, false, false, false}},
        {"r1 = r1 | r2", 0, 0, 0, {false, true, false, false}},
        {"r1 = r1 ^ r2", 0xFFFF, 0x7FFF, 0x8000, {true, false, false, false}},
        {"r1 = r1 &~ r2", 0xFFFF, 0x00FF, 0xFF00, {true, false, false, false}},
        {"r1 & r2", 1, 2, 1, {false, true, false, false}},
        {"r1 = r1 # r2", 0x8000, 0x8000, 0x4000, {false, false, false, false}},
        {"r1 = 5 - r1", 7, 0, 0xFFFE, {true, false, true, false}},
    };
    for (const Case& c : cases) {
        Program p(std::string("start: ") + c.statement + "\n return (r14)\n nop\n");
        p.processor.set_register(1, c.a);
        p.processor.set_register(2, c.b);
        p.call("start");
        EXPECT_EQ(p.r(1), c.result) << c.statement;
        EXPECT_EQ(p.processor.flags(), c.flags) << c.statement;
    }
}

TEST(Processor, bytes_and_halves_lie_with_the_lower_end_at_the_lower_address) {
    Program p(
        "start: r1 = v\n r2l = *r1++\n r3h = *r1++\n r4 = *r1++\n r5 = v\n r6 = 0x1234\n"
        "*r5++ = r6l\n *r5++ = r6h\n *r5++ = r6\n" +
        ending + ".data\nv: .word 0xaabbccdd\n");
    p.call("start");
    EXPECT_EQ(p.r(2), 0x00DD);
    EXPECT_EQ(p.r(3), 0xCC00);
    EXPECT_EQ(p.r(4), 0xAABB);
    EXPECT_EQ(p.word("v"), 0x12341234U);
}

TEST(Processor, integers_become_numbers_and_numbers_integers) {
    Program p(
        "start: r1 = v\n a0 = float(*r1++)\n a1 = float(*r1++)\n r2 = w\n"
        "*r2++ = a2 = int(a1)\n *r2++ = a2 = int(*r3++)\n *r2++ = a2 = int(*r3++)\n"
        "dauc = 0x10\n *r2++ = a2 = int(*r3)\n dauc = 0x30\n *r2++ = a2 = int(*r3)\n" +
        ending + ".data\nv: int 12345, -3\nx: float 2.5, 1e9, -2.5\nw: int 0, 0, 0, 0, 0, 0\n");
    p.processor.set_register(3, static_cast<std::uint16_t>(p.at("x")));
    p.call("start");
    EXPECT_EQ(p.a(0), word_of(12345.0));
    EXPECT_EQ(p.word("w"), 0x0003FFFDU) << "-3, and 2.5 up to 3";
    EXPECT_EQ(p.word("w", 1), 0xFFFD7FFFU) << "the largest, and -2.5 down to -3";
    EXPECT_EQ(p.word("w", 2), 0x0000FFFEU) << "toward zero";
}

TEST(Processor, round_is_to_the_nearest_word) {
    Program p("start: r1 = v\n a0 = *r1++ * *r1++\n nop\n a1 = round(a0)\n" + ending +
              ".data\nv: .word 0, 0\n");
    RandomWords words(13);
    for (int i = 0; i < 10'000; ++i) {
        const Word x = words(), y = words();
        p.word("v") = x;
        p.word("v", 1) = y;
        p.call("start");
        EXPECT_EQ(p.a(1), round(multiply(x, y)));
    }
}

TEST(Processor, flags_of_the_data_unit_say_sign_zero_and_range) {
    Program p("start: r1 = v\n r2 = v + 4\n nop\n a0 = *r1 * *r2\n" + ending +
              ".data\nv: .word 0, 0\n");
    const auto flags = [&](Word x, Word y) {
        p.word("v") = x;
        p.word("v", 1) = y;
        p.call("start");
        return p.processor.data_flags();
    };
    EXPECT_EQ(flags(one, one), (DataFlags{false, false, false, false}));
    EXPECT_EQ(flags(word_of(-2.0), one), (DataFlags{true, false, false, false}));
    EXPECT_EQ(flags(zero, one), (DataFlags{false, true, false, false}));
    EXPECT_EQ(flags(largest, largest), (DataFlags{false, false, true, false}));
    EXPECT_EQ(flags(largest, most_negative), (DataFlags{true, false, true, false}));
    EXPECT_EQ(flags(largest, one), (DataFlags{false, false, false, false}));
    EXPECT_EQ(flags(word_of(0x1p-100), word_of(0x1p-100)), (DataFlags{false, true, false, true}));
}

TEST(Processor, slow_banks_are_seen_through_windows_and_cost_a_cycle_a_word) {
    Program p("start: r1 = 0xf000\n r2 = 3\n *r1 = r2\n r1 = 0xa010\n nop\n a0 = *r1\n" + ending);
    ASSERT_TRUE(p.node.back_buffer().reserve(4 * 4096));
    p.node.back_buffer().words()[3 * 1024 + 4] = word_of(42.0);
    p.call("start");
    EXPECT_EQ(p.a(0), word_of(42.0));
    EXPECT_EQ(p.processor.cycles(), p.processor.instructions() + 1);
}

TEST(Processor, an_access_outside_the_memory_stops_with_address_and_bank) {
    struct Case {
        const char* statement;
        StopReason reason;
        std::uint32_t address;
        const char* bank;
        std::int64_t wanted_bytes, limit_bytes;
    };
    const Case cases[] = {
        {"a0 = *r1", StopReason::fault, 0xA010, "back buffer", 20, 0},
        {"r3 = *0xb008", StopReason::fault, 0xB008, "z-buffer", 10, 8},
        {"r3 = *0x9000", StopReason::fault, 0x9000, "fast memory", 0x9002, 36'864},
        {"*0xe000 = r3", StopReason::fault, 0xE000, "no bank", 0xE002, 0},
        {"r3 = *0x101", StopReason::misaligned, 0x101, "fast memory", 0x103, 36'864},
        {"goto r1", StopReason::fault, 0xA010, "back buffer", 20, 0},
    };
    for (const Case& c : cases) {
        Program p(std::string("start: r1 = 0xa010\n ") + c.statement + "\n" + ending);
        ASSERT_TRUE(p.node.zbuffer().reserve(8));
        const Stop stop = p.run();
        EXPECT_EQ(stop.reason, c.reason) << c.statement;
        EXPECT_EQ(stop.access_address, c.address) << c.statement;
        ASSERT_TRUE(stop.fault) << c.statement;
        EXPECT_EQ(stop.fault->node, 7);
        EXPECT_EQ(stop.fault->bank, c.bank) << c.statement;
        EXPECT_EQ(stop.fault->wanted_bytes, c.wanted_bytes) << c.statement;
        EXPECT_EQ(stop.fault->limit_bytes, c.limit_bytes) << c.statement;
    }
}

TEST(Processor, what_is_not_the_dsp32s_and_what_is_not_modelled_stop) {
    Program p("start: .word 0xffffffff\n");
    EXPECT_EQ(p.run().reason, StopReason::illegal);
    for (const char* statement : {"obuf = a0 = a1", "a0 = ic(*r1)", "a0 = ibuf + a1"}) {
        Program q(std::string("start: ") + statement + "\n" + ending);
        EXPECT_EQ(q.run().reason, StopReason::not_modelled) << statement;
    }
    EXPECT_EQ(Program("start: if (ibf) goto start\n nop\n").run().reason, StopReason::not_modelled);
}

TEST(Processor, a_program_may_rewrite_itself) {
    Program p(
        "start: r3 = 1\n r1 = *other\n r4 = r4 + r3\n *start = r1\n"
        "if (r5-- >= 0) goto start\n nop\n return (r14)\n nop\nother: r3 = 2\n");
    p.call("start");
    EXPECT_EQ(p.r(4), 1 + 2) << "what was executed the first time, and the second";
}

TEST(Processor, steps_and_breakpoints_stop_it) {
    Program p("start: r1 = r1 + 1\n goto start\n nop\n");
    EXPECT_EQ(p.run(1'000'000).reason, StopReason::steps_used);
    EXPECT_EQ(p.processor.instructions(), 1'000'000U);
    const std::uint32_t here[] = {0};
    p.processor.start(0);
    const Stop stop = p.processor.run(100, here);
    EXPECT_EQ(stop.reason, StopReason::breakpoint);
    EXPECT_EQ(stop.instruction_address, 0U);
    EXPECT_EQ(p.processor.instructions(), 1'000'003U);
}

TEST(Processor, random_programs_never_leave_the_node_and_never_hang) {
    const StopCounts stops = try_random_programs(17, 2'000);
    for (const StopReason reason : {StopReason::fault, StopReason::misaligned, StopReason::illegal})
        EXPECT_GT(stops[static_cast<std::size_t>(reason)], 0) << text_of(reason);
}

TEST(Processor, a_run_to_a_breakpoint_is_that_many_single_steps) {
    EXPECT_GT(try_breakpoints(18, 500), 10);
}

}  // namespace
}  // namespace pxm::dsp32::processor
