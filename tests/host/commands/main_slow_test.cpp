// Laws of the program as a process: the documented exit codes, one message on stderr, results on
// stdout, files whole.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/command.hpp"
#include "tests/support/program.hpp"

namespace pxm::test {
namespace {

class Program : public testing::Test {
  protected:
    Program() { folder.write("tetra.pxm", tetra_scene); }

    /// The process and run() agree on everything.
    Outcome agreed(const Arguments& arguments) const {
        const Outcome outcome = run_program(folder, arguments);
        const Outcome within = run(folder, arguments);
        EXPECT_EQ(outcome.exit_code, within.exit_code);
        EXPECT_EQ(outcome.out, within.out);
        EXPECT_EQ(outcome.err, within.err);
        return outcome;
    }
    Folder folder;
};

TEST_F(Program, a_render_and_a_comparison_are_code_0_and_6) {
    const Arguments render{"render", "tetra.pxm", "--size", "16x16", "--quiet", "-o"};
    Arguments fine = render, coarse = render;
    fine.push_back("a.exr");
    coarse.insert(coarse.end(), {"b.exr", "--levels", "0"});
    EXPECT_EQ(agreed(fine).exit_code, 0);
    EXPECT_EQ(run(folder, coarse).exit_code, 0);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "b.exr", "tetra.pxm"}));
    const Outcome differ = agreed({"compare", "a.exr", "b.exr"});
    EXPECT_EQ(differ.exit_code, 6);
    EXPECT_EQ(differ.err, "");
    EXPECT_NE(differ.out, "");
}

TEST_F(Program, mistakes_are_code_2_to_5_with_one_message_and_no_file) {
    const auto before = folder.contents();
    const auto expect = [&](const Arguments& arguments, int code) {
        const Outcome outcome = agreed(arguments);
        EXPECT_EQ(outcome.exit_code, code) << arguments.back();
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.rfind("pxm: ", 0), 0U) << outcome.err;
        EXPECT_EQ(folder.contents(), before);
    };
    expect({"render", "tetra.pxm", "--volume", "round"}, 2);
    expect({"render", "/dev/null", "-o", "a.png"}, 4);
    expect({"render", "tetra.pxm", "--heap", "65536", "--machine", "964dX"}, 5);
    folder.write("empty.pxm", "");
    const Outcome empty = agreed({"render", "empty.pxm"});
    EXPECT_EQ(empty.exit_code, 3);
    EXPECT_EQ(empty.err, "pxm: empty.pxm:1:1: error: the scene is empty\n");
}

}  // namespace
}  // namespace pxm::test
