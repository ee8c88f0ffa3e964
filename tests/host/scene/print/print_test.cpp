// Laws of host/scene/print/print: parse(print(scene)) == scene.
#include "host/scene/print/print.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/host/scene/random_scene.hpp"
#include "tests/host/scene/scene_text.hpp"

namespace pxm::host {
namespace {

TEST(Print, what_is_printed_reads_back_as_the_same_scene) {
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const Scene scene = test::RandomScene(seed).scene();
        const std::string text = print_scene(scene);
        Diagnostics diagnostics;
        const Scene again = parse_text("s.pxm", text, diagnostics);
        ASSERT_EQ(diagnostics.text(again.files), "") << "seed " << seed << "\n" << text;
        ASSERT_TRUE(again == scene) << "seed " << seed << "\n" << text;
        ASSERT_EQ(print_scene(again), text) << "seed " << seed;
    }
}

TEST(Print, scenes_that_differ_in_one_value_print_differently) {
    const Scene scene = test::parsed("ifs a { newmap scale: 0.1 }");
    Scene other = scene;
    std::get<ScaleCommand>(other.ifs[0].maps[0].commands[0].kind).factors.y =
        std::nextafter(0.1, 1.0);
    EXPECT_NE(print_scene(scene), print_scene(other));
}

TEST(Print, the_layout_is_one_directive_a_line) {
    EXPECT_EQ(
        print_scene(test::parsed(
            "object o { ifs: a sphere: (0,0,0) 3 levels: 2 } camera { eye: 0.10,0,-5 fov: 40 }"
            "ifs a { newmap stem scale: 1/2 rotate: y,45 color: 0,1,0,1 newmap "
            "follow: stem -> 2 start: stem,2 } render { shading: low-pass covers: on }")),
        "render {\n"
        "    shading: low-pass\n"
        "    covers: 0.05,2\n"
        "}\n"
        "\n"
        "camera {\n"
        "    eye: 0.10,0,-5\n"
        "    fov: 40\n"
        "}\n"
        "\n"
        "ifs a {\n"
        "    newmap stem\n"
        "        scale: 0.5,0.5,0.5\n"
        "        rotate: y,45\n"
        "        color: 0,1,0,1\n"
        "    newmap\n"
        "    follow: stem -> 2\n"
        "    start: stem, 2\n"
        "}\n"
        "\n"
        "object o {\n"
        "    ifs: a\n"
        "    sphere: (0,0,0) 3\n"
        "    levels: 2\n"
        "}\n");
}

}  // namespace
}  // namespace pxm::host
