// Laws of `pxm compare`.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

class Compare : public testing::Test {
  protected:
    Compare() {
        folder.write("tetra.pxm", tetra_scene);
        render("a.exr", {});
    }
    void render(const std::string& out, Arguments options) const {
        options.insert(options.begin(), {"render", "tetra.pxm", "-o", out, "--aov", "Z,word,object",
                                         "--size", "40x30"});
        if (out == "plain.exr") options.erase(options.begin() + 4, options.begin() + 6);
        expect_done(folder, options);
    }
    Folder folder;
};

TEST_F(Compare, a_render_is_equal_to_itself) {
    const Outcome same = run(folder, {"compare", "a.exr", "a.exr"});
    EXPECT_EQ(same.exit_code, 0);
    EXPECT_EQ(same.err, "");
    EXPECT_EQ(same.out,
              "different hits               0.000000 %\n"
              "different words              0.000000 %\n"
              "depths over a pixel apart    0.000000 %\n"
              "largest depth difference     0 pixels\n"
              "colours over 1/255 apart     0.000000 %\n"
              "RMSE of colour               0\n"
              "different pixels             0.000000 % (within the tolerance of 0.000000 %)\n");
}

TEST_F(Compare, a_difference_is_code_6_unless_tolerated) {
    render("coarse.exr", {"--levels", "1"});
    const Outcome over = run(folder, {"compare", "a.exr", "coarse.exr"});
    EXPECT_EQ(over.exit_code, 6);
    EXPECT_EQ(over.err, "");
    EXPECT_EQ(over.out.find("different hits               0.000000 %"), std::string::npos);
    EXPECT_NE(over.out.find("(over the tolerance of 0.000000 %)"), std::string::npos) << over.out;
    const Outcome within = run(folder, {"compare", "a.exr", "coarse.exr", "--tolerance", "1"});
    EXPECT_EQ(within.exit_code, 0);
    EXPECT_NE(within.out.find("(within the tolerance of 100.000000 %)"), std::string::npos);
}

TEST_F(Compare, machine_and_native_are_equal) {
    render("machine.exr", {"--machine", "964dX"});
    EXPECT_EQ(run(folder, {"compare", "a.exr", "machine.exr"}).exit_code, 0);
}

TEST_F(Compare, other_words_hide_no_colours) {
    // The same triangle by other words, in another colour.
    const std::string light = "light { direction: 0,0,-1 } image { size: 16,16 }\n";
    folder.write("red.pxm",
                 "ifs s { newmap scale: 1/2 newmap scale: 1/2 translate: 1/2,0,0\n"
                 "newmap scale: 1/2 translate: 0,1/2,0 }\n"
                 "object o { ifs: s color: 1,0,0,1 }\n" +
                     light);
    folder.write("green.pxm",
                 "ifs s { newmap scale: 1/2 translate: 0,1/2,0 newmap scale: 1/2\n"
                 "newmap scale: 1/2 translate: 1/2,0,0 }\n"
                 "object o { ifs: s color: 0,1,0,1 }\n" +
                     light);
    for (const std::string name : {"red", "green"})
        expect_done(folder,
                    {"render", name + ".pxm", "-o", name + ".exr", "--aov", "Z,word,object"});
    const Outcome outcome = run(folder, {"compare", "red.exr", "green.exr"});
    EXPECT_EQ(outcome.exit_code, 6) << outcome.out;
    EXPECT_EQ(outcome.out.find("colours over 1/255 apart     0.000000 %"), std::string::npos);
    EXPECT_NE(outcome.out.find("\n  of them in other cells "), std::string::npos) << outcome.out;
}

TEST_F(Compare, channels_that_are_not_there_are_told) {
    render("plain.exr", {});
    const Outcome outcome = run(folder, {"compare", "a.exr", "plain.exr"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.out.find("different hits               -            (no such channel in "
                               "both files)\n"),
              std::string::npos)
        << outcome.out;
}

TEST_F(Compare, files_that_cannot_be_compared_are_code_4) {
    render("small.exr", {"--crop", "0,0,8,8"});
    folder.write("text.exr", "no picture");
    expect_refusal(folder, {"compare", "a.exr", "small.exr"}, 4,
                   "the images differ in size: 40x30 and 8x8");
    expect_refusal_naming(folder, {"compare", "a.exr", "none.exr"}, 4, {"cannot read none.exr: "});
    expect_refusal_naming(folder, {"compare", "text.exr", "a.exr"}, 4, {"cannot read text.exr: "});
    expect_refusal_naming(folder, {"compare", ".", "a.exr"}, 4, {"cannot read .: "});
    expect_refusal_naming(folder, {"compare", "tetra.pxm", "a.exr"}, 4,
                          {"cannot read tetra.pxm: "});
}

TEST_F(Compare, a_tolerance_is_a_share) {
    for (const std::string text : {"-0.1", "1.5", "nan", "x"}) {
        expect_refusal(folder, {"compare", "a.exr", "a.exr", "--tolerance", text}, 2,
                       "--tolerance: found \"" + text +
                           "\", expected a number from 0 to 1\ntry: pxm --help, or pxm COMMAND "
                           "--help");
    }
}

}  // namespace
}  // namespace pxm::test
