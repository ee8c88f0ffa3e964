// Laws of bad input: whatever the scene file is, one message, the documented exit code, and every
// file as it was.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <string>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

/// A folder with an older picture that no failing run may touch.
class BadScene : public testing::Test {
  protected:
    BadScene() { folder.write("old.png", "an older picture"); }

    void refuse(const std::string& scene, const std::string& message) const {
        folder.write("a.pxm", scene);
        SCOPED_TRACE(message);
        expect_refusal(folder, {"render", "a.pxm", "-o", "old.png"}, 3, "a.pxm:" + message);
    }
    void refuse_naming(const std::string& scene, const std::vector<std::string>& parts) const {
        folder.write("a.pxm", scene);
        SCOPED_TRACE(parts.back());
        expect_refusal_naming(folder, {"render", "a.pxm", "-o", "old.png"}, 3, parts);
    }
    Folder folder;
};

TEST_F(BadScene, a_scene_file_that_cannot_be_read_is_code_4) {
    const auto refused = [&](const std::string& scene, const std::string& why) {
        expect_refusal(folder, {"render", scene, "-o", "old.png"}, 4, scene + ": " + why);
    };
    refused("missing.pxm", "no such file");
    mkdir(folder.path("folder").c_str(), 0777);
    refused("folder", "is a directory");
    mkfifo(folder.path("pipe").c_str(), 0666);
    refused("pipe", "not a regular file");
}

TEST_F(BadScene, a_file_that_is_no_scene_is_code_3) {
    refuse("", "1:1: error: the scene is empty");
    refuse("# only a comment\n", "1:1: error: the scene is empty\n    # only a comment\n    ^");
    std::string bytes(
        "\x7f"
        "ELF\x02\x01\x01",
        7);
    for (unsigned i = 0; i < 100'000; ++i) bytes += static_cast<char>(i * i % 251);
    refuse_naming(bytes, {"error: byte 0x00: this is not a text file"});
    refuse_naming("\xff\xfe\x80\x81", {"1:1: error: expected a block, found byte 0xFF"});
}

TEST_F(BadScene, a_megabyte_of_braces_is_refused_at_once) {
    folder.write("a.pxm", std::string(1 << 20, '{'));
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = run(folder, {"render", "a.pxm"});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_LT(seconds.count(), 5) << "a second, on a computer that is busy";
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_LT(outcome.err.size(), 10'000U);
    EXPECT_NE(outcome.err.find("a.pxm:1:1: error: expected a block, found '{'"), std::string::npos);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.pxm", "old.png"}));
}

TEST_F(BadScene, an_unknown_name_is_code_3) {
    const std::string tetra = tetra_scene;
    refuse(tetra + "object o { ifs: teapot }\n",
           "7:17: error: there is no ifs \"teapot\"\n    object o { ifs: teapot }\n"
           "                    ^");
    refuse_naming(tetra + "sphere s { }\n", {"7:1: error: expected a block, found 'sphere'"});
    refuse_naming("ifs a { newmap one scale: 0.5 follow: one -> two }",
                  {"a.pxm:1:46: error: ", "two"});
}

TEST_F(BadScene, a_map_that_does_not_contract_is_named) {
    refuse("ifs a {\n    newmap small scale: 0.5\n    newmap large scale: 1.25\n}\n",
           "1:1: error: ifs \"a\" could not be shown to contract: map \"large\" has Lipschitz "
           "constant 1.25\n    ifs a {\n    ^");
}

TEST_F(BadScene, a_number_that_is_none_or_too_large_is_code_3) {
    refuse_naming("ifs a { newmap scale: nan }", {"1:23: error: expected a number, found 'nan'"});
    refuse_naming("ifs a { newmap scale: inf }", {"1:23: error: expected a number, found 'inf'"});
    refuse_naming("ifs a { newmap scale: 1e999 }", {"1:23: error: this number is too large"});
    refuse_naming("ifs a { newmap scale: 0/0 }", {"error: division by zero"});
    refuse_naming("ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 1e308,1e308,0 }",
                  {"error: object \"a\" is too large or too far away"});
    const std::string tetra = tetra_scene;
    refuse_naming(tetra + "camera { eye: 0,0,-1e200 }",
                  {"7:1: error: the camera's numbers are too large"});
    refuse_naming(tetra + "camera { eye: 0,0,-5 up: 1e300,1e300,0 }",
                  {"7:1: error: the camera's numbers are too large"});
}

TEST_F(BadScene, an_image_of_no_or_of_a_billion_pixels_is_code_3) {
    const std::string tetra = tetra_scene;
    for (const char* side : {"0", "1000000000", "-5"}) {
        refuse_naming(
            tetra + fmt::format("image {{ size: {},16 }}", side),
            {fmt::format("7:1: error: image: 'size' is {}: it must lie in 1..65536", side)});
    }
    refuse_naming(tetra + "image { size: 8,8 crop: 0,0,9,8 }",
                  {"error: image: 'crop' is not inside the image of 8,8"});
}

TEST_F(BadScene, a_map_or_volume_that_chapter_13_does_not_project_is_named) {
    const std::string fast = "render { intersect: fast }\n";
    refuse(fast + "ifs a {\n    newmap scale: 0.5\n    newmap turned scale: 0.5 rotate: y,9\n}\n",
           "4:5: error: intersect: fast takes maps that scale uniformly and translate; map "
           "\"turned\" of ifs \"a\" does more\n    newmap turned scale: 0.5 rotate: y,9\n"
           "    ^");
    refuse(fast +
               "ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 }\n"
               "object o { ifs: a box: (-1,-1,-1)(3,1,1) }\n",
           "3:1: error: intersect: fast takes bounding spheres; object \"o\" has another volume "
           "(say volume: sphere)\n    object o { ifs: a box: (-1,-1,-1)(3,1,1) }\n    ^");
    refuse(tetra_scene + std::string("render { intersect: fast covers: on }\n"),
           "7:10: error: intersect: fast finds the first cell along a ray; local covers and "
           "translucent objects take the cells behind it too\n"
           "    render { intersect: fast covers: on }\n             ^");
}

TEST_F(BadScene, several_errors_are_told_in_one_run) {
    refuse_naming(
        std::string(tetra_scene) + "object o { ifs: b }\nobject p { ifs: c }\n",
        {"a.pxm:7:17: error: there is no ifs \"b\"", "a.pxm:8:17: error: there is no ifs \"c\""});
}

TEST_F(BadScene, a_scene_beyond_the_machine_is_code_5_and_fits_the_cores) {
    std::string many = "ifs many {\n";
    for (int i = 0; i < 4096; ++i) {
        many +=
            fmt::format("newmap scale: 0.01 translate: {},{},0\n", i % 64 / 64.0, i / 64 / 64.0);
    }
    folder.write("many.pxm", many + "}\n");
    const Arguments render{"render", "many.pxm", "-o", "old.png", "--size", "8x8"};
    Arguments on_machine = render;
    on_machine.insert(on_machine.end(), {"--machine", "964dX"});
    expect_refusal_naming(
        folder, on_machine, 5,
        {"the back buffer of node 0 of the 964dX is too small: ", " bytes wanted, 262144 there\n"});
    expect_done(folder, render);
}

TEST_F(BadScene, a_heap_beyond_the_machine_is_code_5) {
    folder.write("tetra.pxm", tetra_scene);
    expect_refusal_naming(
        folder, {"render", "tetra.pxm", "-o", "old.png", "--heap", "65536", "--machine", "964dX"},
        5, {"does not fit the fast memory of the 964dX: ", " bytes wanted, 36864 there\n", "heap"});
}

TEST_F(BadScene, a_raster_beyond_the_machine_is_code_5) {
    folder.write("tetra.pxm", tetra_scene);
    expect_refusal(
        folder, {"render", "tetra.pxm", "-o", "old.png", "--size", "4096x4096", "--machine", "964"},
        5,
        "the front buffer of node 0 of the 964 is too small: 1048576 bytes wanted, "
        "262144 there");
}

}  // namespace
}  // namespace pxm::test
