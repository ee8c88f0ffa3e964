// Laws of `pxm asm`: the object, the listing, the run, and what it refuses.
#include <gtest/gtest.h>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

const char* const sum_source =
    "start:  r1 = v\n"
    "        a0 = *r1++ * *r1++\n"
    "        nop\n"
    "        return (r14)\n"
    "        nop\n"
    "        .data\n"
    "v:      float 1.5, 4\n";

class AsmCommand : public testing::Test {
  protected:
    AsmCommand() { folder.write("sum.s", sum_source); }
    /// What is printed, of a command that does its work.
    std::string shown(const Arguments& options) const {
        Arguments words{"asm"};
        words.insert(words.end(), options.begin(), options.end());
        const Outcome outcome = run(folder, words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome.out;
    }
    Folder folder;
};

TEST_F(AsmCommand, the_object_of_a_source_is_written_beside_nothing_else) {
    EXPECT_EQ(expect_done(folder, {"asm", "sum.s"}), "sum.o: 7 words of 9216\n");
    EXPECT_EQ(folder.contents().at("sum.o"),
              "pxm-object 1 dsp32\ntext 5\n14200014\n7003c787\n00000000\n002e0000\n00000000\n"
              "data 2\n40000080\n00000082\nsymbol 0000 start\nsymbol 0014 v\n");
    EXPECT_EQ(shown({"sum.o"}),
              "start:\n        r1 = 0x14\n        a0 = *r1++ * *r1++\n        nop\n"
              "        goto r14\n        nop\n        .data\nv:\n        .word 0x40000080\n"
              "        .word 0x00000082\n");
}

TEST_F(AsmCommand, a_listing_shows_words_and_writes_nothing) {
    const auto before = folder.contents();
    EXPECT_EQ(shown({"sum.s", "--list"}),
              "0000  14200014  start:  r1 = v\n"
              "0004  7003c787          a0 = *r1++ * *r1++\n"
              "0008  00000000          nop\n"
              "000c  002e0000          return (r14)\n"
              "0010  00000000          nop\n"
              "                        .data\n"
              "0014  40000080  v:      float 1.5, 4\n"
              "0018  00000082\n");
    EXPECT_EQ(folder.contents(), before);
}

TEST_F(AsmCommand, a_run_says_what_it_left_and_what_it_took) {
    EXPECT_EQ(shown({"sum.s", "--run", "start"}),
              "ended at fffc: 5 instructions, 5 cycles, 0.001 ms\n"
              "r1 = 001c  r14 = fffc  a0 = 6 (40000082)\n");
    EXPECT_EQ(shown({"sum.s", "--run", "start", "--trace"}),
              "0000  r1 = 0x14                                 r1 = 0014\n"
              "0004  a0 = *r1++ * *r1++                        r1 = 001c  a0 = 6 (40000082)\n"
              "0008  nop                                     \n"
              "000c  goto r14                                \n"
              "0010  nop                                     \n"
              "ended at fffc: 5 instructions, 5 cycles, 0.001 ms\n"
              "r1 = 001c  r14 = fffc  a0 = 6 (40000082)\n");
    folder.write("early.s",
                 "start: r1 = v\n a0 = *r1\n a1 = a0 * a0\nend: return (r14)\n nop\n"
                 "v: float 2\n");
    EXPECT_EQ(shown({"early.s", "--run", "start", "--break", "end"}),
              "is at a breakpoint at 000c: 3 instructions, 3 cycles, 0.0006 ms\n"
              "2 reads got an old value from the pipeline, the first an accumulator at 0008\n"
              "r1 = 0014  r14 = fffc  a0 = 2 (00000081)\n");
}

TEST_F(AsmCommand, mistakes_are_shown_at_their_places_with_code_3) {
    folder.write("wrong.s", "start:  frob r1\n        a0 = a1 * 3.0\n");
    expect_refusal(folder, {"asm", "wrong.s"}, 3,
                   "wrong.s:1:9: error: unknown instruction \"frob\"\n"
                   "    start:  frob r1\n"
                   "            ^\n"
                   "wrong.s:2:19: error: expected an accumulator or memory, found \"3.0\"\n"
                   "    a0 = a1 * 3.0\n"
                   "              ^");
    folder.write("bad.o", "pxm-object 1 dsp32\ntext 5\n");
    expect_refusal(folder, {"asm", "bad.o"}, 3, "bad.o: no object of this version");
}

TEST_F(AsmCommand, several_files_are_read_as_one_and_mistakes_name_theirs) {
    folder.write("main.s", "start: r13 = r14\n call twice (r14)\n nop\n return (r13)\n nop");
    folder.write("twice.s", "twice: r1 = 0x21\n r1 = r1 * 2\n return (r14)\n nop\n");
    EXPECT_EQ(shown({"main.s", "twice.s", "--run", "start"}),
              "ended at fffc: 9 instructions, 9 cycles, 0.0018 ms\n"
              "r1 = 0042  r13 = fffc  r14 = 000c\n");
    folder.write("more.s", "nop\nfrob\n");
    expect_refusal(folder, {"asm", "main.s", "twice.s", "more.s"}, 3,
                   "more.s:2:1: error: unknown instruction \"frob\"\n    frob\n    ^");
}

TEST_F(AsmCommand, what_does_not_fit_is_code_5_with_words_and_limit) {
    folder.write("large.s", "nop\n.space 40000\n");
    expect_refusal(folder, {"asm", "large.s"}, 5,
                   "the program takes 10001 words of fast memory, 9216 are there");
}

TEST_F(AsmCommand, a_program_that_leaves_its_node_is_code_5_and_one_that_does_not_end_code_1) {
    folder.write("out.s", "start: r1 = 0xa000\n nop\n a0 = *r1\n nop\n");
    const Outcome out = run(folder, {"asm", "out.s", "--run", "start"});
    EXPECT_EQ(out.exit_code, 5);
    EXPECT_EQ(
        out.err,
        "pxm: the program left the node's memory at 0008: address a000, back buffer of node 0: "
        "4 bytes wanted, 0 there\n");
    folder.write("long.s", "start: goto start\n nop\n");
    const Outcome late = run(folder, {"asm", "long.s", "--run", "start", "--steps", "2500000"});
    EXPECT_EQ(late.exit_code, 1);
    EXPECT_EQ(late.err, "pxm: the program used all its steps at 0000\n");
    EXPECT_EQ(late.out.substr(0, 64),
              "used all its steps at 0000: 2500000 instructions, 2500000 cycles");
}

TEST_F(AsmCommand, an_unknown_label_and_the_source_as_object_are_code_2) {
    expect_refusal(folder, {"asm", "sum.s", "--run", "stop"}, 2,
                   "there is no label stop in the program");
    expect_refusal_naming(folder, {"asm", "sum.s", "-o", "sum.s"}, 2, {"what is assembled"});
    expect_refusal_naming(folder, {"asm", "none.s"}, 4, {"none.s"});
}

}  // namespace
}  // namespace pxm::test
