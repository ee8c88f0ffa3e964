// Laws of `pxm render --program`: the file is that of the counted kernels, and what only they have
// is refused.
#include <gtest/gtest.h>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

class RenderProgram : public testing::Test {
  protected:
    RenderProgram() { folder.write("tetra.pxm", tetra_scene); }
    /// The words of a render on the machine, and more.
    static Arguments machine(const Arguments& more) {
        Arguments words{"render", "tetra.pxm", "--size", "24x18", "--machine", "964dX"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    Folder folder;
};

TEST_F(RenderProgram, in_dsp32_code_the_file_is_the_same_to_the_last_byte) {
    expect_done(folder, machine({"-o", "default.png"}));
    expect_done(folder, machine({"--program", "default", "-o", "named.png"}));
    expect_done(folder, machine({"--program", "asm", "-o", "asm.png"}));
    expect_done(folder, machine({"--program", "asm", "-o", "parts", "--part", "1/2"}));
    expect_done(folder, machine({"--program", "asm", "-o", "parts", "--part", "2/2"}));
    expect_done(folder, {"join", "parts", "-o", "joined.png"});
    const auto files = folder.contents();
    EXPECT_EQ(files.at("named.png"), files.at("default.png"));
    EXPECT_EQ(files.at("asm.png"), files.at("default.png"));
    EXPECT_EQ(files.at("joined.png"), files.at("default.png"));
}

TEST_F(RenderProgram, parts_of_two_programs_do_not_make_a_picture) {
    expect_done(folder, machine({"--program", "asm", "-o", "parts", "--part", "1/2"}));
    expect_refusal_naming(folder, machine({"-o", "parts", "--part", "2/2"}), 4,
                          {"program of the nodes"});
}

TEST_F(RenderProgram, what_only_the_counted_kernels_have_is_refused) {
    expect_refusal(folder, {"render", "tetra.pxm", "--program", "asm"}, 2,
                   "--program asm: only the machine's nodes run it (--machine MODEL)");
    expect_refusal(folder, machine({"--program", "c++"}), 2,
                   "--program: expected default or asm, found c++");
    expect_refusal(folder, machine({"--program", "asm", "--pixel", "3,4"}), 2,
                   "--pixel: a descent is told by the counted kernels, not by --program asm");
    expect_refusal(folder, machine({"--program", "asm", "-o", "a.exr", "--aov", "heap"}), 2,
                   "--aov heap: the most cells in the heap are not known with --program asm");
    expect_refusal(folder, machine({"--program", "asm", "--cost-model", "x.json"}), 2,
                   "--cost-model: with --program asm cycles are those of its instructions");
}

TEST_F(RenderProgram, a_scene_that_it_does_not_know_is_refused_and_nothing_is_written) {
    expect_refusal(folder, machine({"--program", "asm", "--volume", "hull"}), 3,
                   "--program asm: the scene has a bounding volume that is no ball and no box in "
                   "axes (--volume sphere, or box); what the program knows: docs/dsp32.md, \"The "
                   "node program\"");
}

}  // namespace
}  // namespace pxm::test
