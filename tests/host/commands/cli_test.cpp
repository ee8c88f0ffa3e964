// Laws of the command line: what it answers, and what it refuses with exit code 2 or 4.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

const std::string usage = "\ntry: pxm --help, or pxm COMMAND --help";

/// A folder with a scene, an older picture, and a folder.
class CommandLine : public testing::Test {
  protected:
    CommandLine() {
        folder.write("tetra.pxm", tetra_scene);
        folder.write("old.png", "an older picture");
        mkdir(folder.path("folder").c_str(), 0777);
    }
    /// `pxm render tetra.pxm -o old.png ...` is refused with code 2.
    void refuse(const Arguments& options, const std::string& message) const {
        Arguments words{"render", "tetra.pxm"};
        if (options.front() != "-o") words.insert(words.end(), {"-o", "old.png"});
        words.insert(words.end(), options.begin(), options.end());
        SCOPED_TRACE(message);
        expect_refusal(folder, words, 2, message);
    }
    Folder folder;
};

TEST_F(CommandLine, help_and_version_are_answered_on_stdout) {
    for (const Arguments& question :
         {Arguments{"--help"}, {"--version"}, {"render", "--help"}, {"compare", "--help"}}) {
        const Outcome outcome = run(folder, question);
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_EQ(outcome.err, "");
        EXPECT_NE(outcome.out.find(question.back() == "--version" ? "pxm 0." : "Usage: pxm"),
                  std::string::npos)
            << outcome.out;
    }
}

TEST_F(CommandLine, a_missing_or_unknown_command_is_code_2) {
    expect_refusal(folder, {}, 2, "A subcommand is required" + usage);
    expect_refusal_naming(folder, {"redner", "tetra.pxm"}, 2,
                          {"unknown command \"redner\", expected one of", "render", "compare"});
    expect_refusal(folder, {"render"}, 2, "scene is required" + usage);
    expect_refusal(folder, {"compare", "a.exr"}, 2, "b is required" + usage);
    expect_refusal(folder, {"render", ""}, 2, "scene: found \"\", expected a value" + usage);
}

TEST_F(CommandLine, an_unknown_option_is_code_2) {
    refuse({"--frob"}, "The following argument was not expected: --frob" + usage);
    refuse({"tetra.pxm"}, "The following argument was not expected: tetra.pxm" + usage);
    refuse({"--native", "--machine", "964"}, "--native excludes --machine" + usage);
    refuse({"--machine"}, "--machine: 1 required 916|920|932|940|964|964dX missing" + usage);
}

TEST_F(CommandLine, an_unknown_option_value_is_code_2_and_told_what_is_expected) {
    refuse(
        {"--machine", "965"},
        "--machine: found \"965\", expected a model out of 916 920 932 940 964 964dX (did you mean "
        "'964'?)");
    refuse({"--shading", "phong"},
           "--shading: found \"phong\", expected one of constant, low-pass, high-pass, facet");
    refuse({"--numeric", "half"},
           "--numeric: found \"half\", expected one of dsp32, float, double");
    refuse({"--intersect", "slow"},
           "--intersect: found \"slow\", expected one of auto, heap, fast, wide");
    refuse({"--lipschitz", "x"},
           "--lipschitz: found \"x\", expected one of auto, product, determinant, polar");
    refuse({"--volume", "cone"},
           "--volume: found \"cone\", expected one of auto, sphere, box, oriented, hull");
    for (const std::string range : {"2,1", "1,inf", "nan,2"}) {
        refuse({"--covers", range}, "--covers: found \"" + range +
                                        "\", expected on, off, area, or tmin,tmax in pixels with "
                                        "0 < tmin < tmax");
    }
    refuse({"-o", "x.exr", "--aov", "Z,Q"},
           "--aov: found \"Q\", expected names out of Z node cycles volumes level heap alpha "
           "object word N neighbours, separated by commas");
}

TEST_F(CommandLine, a_number_out_of_range_is_code_2) {
    const std::string size = "expected WxH with 1 to 65536 pixels a side, as in 640x480";
    for (const char* text : {"0x0", "1000000000x1000000000", "64", "64x", "-1x4", "4x4x4", "axb"}) {
        refuse({"--size", text}, "--size: found \"" + std::string(text) + "\", " + size);
    }
    for (const char* text : {"0", "-1", "nan", "inf", "two"}) {
        refuse({"--zoom", text},
               "--zoom: found \"" + std::string(text) + "\", expected a number above 0" + usage);
        refuse({"--detail", text},
               "--detail: found \"" + std::string(text) + "\", expected a number above 0" + usage);
    }
    refuse({"--threads", "0"},
           "--threads: found \"0\", expected a whole number from 1 to 1024" + usage);
    refuse({"--heap", "65537"},
           "--heap: found \"65537\", expected a whole number from 1 to 65536" + usage);
    refuse({"--levels", "-1"},
           "--levels: found \"-1\", expected a whole number from 0 to 1000000000" + usage);
    refuse({"--size", ""}, "--size: found \"\", expected a value" + usage);
}

TEST_F(CommandLine, a_window_or_pixel_outside_the_image_is_code_2) {
    refuse({"--crop", "4,4,4,8"},
           "--crop: found \"4,4,4,8\", expected x0,y0,x1,y1 with x0 < x1 and y0 < y1 (half open)");
    refuse({"--crop", "0,0,641,480"}, "--crop 0,0,641,480 is not inside the 640x480 image");
    refuse({"--size", "8x8", "--crop", "0,0,8,9"}, "--crop 0,0,8,9 is not inside the 8x8 image");
    refuse({"--pixel", "640,0"}, "--pixel 640,0 is outside the 640x480 image");
    refuse({"--pixel", "0,-1"}, "--pixel 0,-1 is outside the 640x480 image");
    refuse({"--pixel", "7"}, "--pixel: found \"7\", expected x,y");
}

TEST_F(CommandLine, the_wide_engine_where_it_does_not_apply_is_code_2) {
    refuse({"--intersect", "wide", "--numeric", "double"},
           "--intersect wide: the numbers are double, and the wide engine's are float");
}

TEST_F(CommandLine, an_output_that_is_no_picture_format_is_code_2) {
    for (const std::string extension : {"foo", "txt", "pxm", "null", "term", "zfile"}) {
        refuse({"-o", "x." + extension}, "cannot write x." + extension +
                                             ": unknown image extension \"" + extension +
                                             "\" (png, exr, tif, jpg, ...)");
    }
    refuse({"-o", "x"}, "cannot write x: unknown image extension \"\" (png, exr, tif, jpg, ...)");
    refuse({"--aov", "Z"}, "--aov needs an .exr output, not old.png");
    refuse({"-o", "x.exr", "--aov", "cycles"},
           "--aov cycles: cycles are counted on the machine only (--machine MODEL)");
}

TEST_F(CommandLine, no_file_is_written_over_another) {
    refuse({"--stats", "./tetra.pxm"}, "./tetra.pxm would be written over the scene");
    refuse({"-o", "new.png", "--stats", "./new.png"},
           "./new.png would be written over the picture");
    folder.write("scene.png", tetra_scene);
    expect_refusal(folder, {"render", "scene.png"}, 2, "scene.png would be written over the scene");
}

TEST_F(CommandLine, a_place_that_cannot_be_written_is_code_4) {
    const auto refused = [&](const std::string& out, const std::string& why) {
        expect_refusal(folder, {"render", "tetra.pxm", "-o", out}, 4,
                       "cannot write " + out + ": " + why);
    };
    refused("nowhere/x.png", "its folder does not exist");
    refused("tetra.pxm/x.png", "its folder is not a directory");
    mkdir(folder.path("folder.png").c_str(), 0777);
    refused("folder.png", "it is a directory");
    refused(std::string(252, 'x') + ".png", "File name too long");
    expect_refusal(folder, {"render", "tetra.pxm", "-o", "x.png", "--stats", "nowhere/s.json"}, 4,
                   "cannot write nowhere/s.json: its folder does not exist");
    // Nobody can create a file there, not even who may do everything.
    expect_refusal_naming(folder, {"render", "tetra.pxm", "-o", "/proc/x.png", "--size", "8x8"}, 4,
                          {"cannot write /proc/x.png: "});
}

TEST_F(CommandLine, a_folder_without_permission_is_code_4) {
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    chmod(folder.path("folder").c_str(), 0555);
    expect_refusal(folder, {"render", "tetra.pxm", "-o", "folder/x.png"}, 4,
                   "cannot write folder/x.png: Permission denied");
    chmod(folder.path("folder").c_str(), 0777);
}

}  // namespace
}  // namespace pxm::test
