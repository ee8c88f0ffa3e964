// Laws of what a command loads: nothing that it does not use.
#include <gtest/gtest.h>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/program.hpp"

namespace pxm::test {
namespace {

/// Whether the dynamic linker came by OpenImageIO in a run that succeeds.
bool loads_openimageio(const Folder& folder, const Arguments& arguments) {
    const Outcome outcome = run_program(folder, arguments, {"LD_DEBUG=files"});
    EXPECT_EQ(outcome.exit_code, 0) << arguments[0];
    EXPECT_NE(outcome.err.find("libstdc++"), std::string::npos) << "the linker told nothing";
    return outcome.err.find("libOpenImageIO") != std::string::npos;
}

class Start : public testing::Test {
  protected:
    Start() {
        folder.write("tetra.pxm", tetra_scene);
        folder.write("f.ifs", "b { .5 0 0 .5 0 0 .5 .5 0 0 .5 1 0 .5 }");
    }
    Folder folder;
};

TEST_F(Start, takes_no_image_library_where_no_other_picture_than_png_or_exr_is_written) {
    const Arguments commands[] = {
        {"--version"},
        {"render", "--help"},
        {"models"},
        {"check", "tetra.pxm"},
        {"inspect", "tetra.pxm"},
        {"import", "f.ifs", "-o", "f.pxm"},
        {"points", "tetra.pxm", "-n", "10", "-o", "a.ply"},
        {"render", "tetra.pxm", "--pixel", "3,3", "--size", "8x8"},
        {"render", "tetra.pxm", "-o", "a.png", "--size", "8x8", "--quiet", "--stats", "a.json"},
        {"render", "tetra.pxm", "-o", "a.exr", "--size", "8x8", "--quiet", "--aov", "Z,N"},
    };
    for (const Arguments& arguments : commands)
        EXPECT_FALSE(loads_openimageio(folder, arguments)) << arguments[0];
}

TEST_F(Start, takes_it_where_a_picture_needs_it) {
    EXPECT_TRUE(loads_openimageio(
        folder, {"render", "tetra.pxm", "-o", "a.tif", "--size", "8x8", "--quiet"}));
    expect_done(folder, {"render", "tetra.pxm", "-o", "a.exr", "--size", "8x8", "--quiet"});
    EXPECT_TRUE(loads_openimageio(folder, {"compare", "a.exr", "a.exr"}));
}

TEST_F(Start, measures_no_clock) {
    const Outcome outcome =
        run_program(folder, {"--version"}, {"LD_DEBUG=bindings", "LD_BIND_NOW=1"});
    const auto at = outcome.err.find("platform15TimerResolution");
    ASSERT_NE(at, std::string::npos);
    const auto target = outcome.err.rfind(" to ", at);
    ASSERT_NE(target, std::string::npos);
    EXPECT_EQ(outcome.err.substr(target, 8), " to pxm ") << "the program's own comes first";
}

}  // namespace
}  // namespace pxm::test
