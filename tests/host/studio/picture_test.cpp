// The laws of host/studio/picture.hpp, exact_point.hpp, picked_cell.hpp and scene_view.hpp: what
// the page shows is what a render gives, and where it flies to is on the attractor.
#include "host/studio/picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "host/error.hpp"
#include "host/inspect/attractor_point.hpp"
#include "host/output/image.hpp"
#include "host/scene/default_objects.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/studio/exact_point.hpp"
#include "host/studio/picked_cell.hpp"
#include "host/studio/scene_view.hpp"
#include "tests/support/command.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

AskedPicture asked(const std::string& text, long columns, long rows) {
    AskedPicture picture;
    picture.scene.name = "a.pxm";
    picture.scene.text = text;
    picture.size = {columns, rows};
    return picture;
}

TEST(Picture, is_the_file_that_render_writes) {
    const test::Folder folder;
    folder.write("a.pxm", test::tetra_scene);
    AskedPicture picture = asked(test::tetra_scene, 90, 150);  // three bands of rows
    picture.samples = 4;
    picture.settings = {
        {"camera.eye", "0.3,0.4,-2.5"}, {"camera.look", "0,0.1,0"}, {"camera.zoom", "1.5"}};
    std::atomic<bool> stop = false;
    const Picture made = picture_asked(picture, 1, stop);
    test::expect_done(folder, {"render", "a.pxm", "--size", "90x150", "--samples", "4", "--set",
                               "camera.eye=0.3,0.4,-2.5", "--set", "camera.look=0,0.1,0", "--set",
                               "camera.zoom=1.5", "-o", "a.png", "--quiet", "--no-scene"});
    EXPECT_EQ(png_bytes(made), folder.read("a.png"));
}

TEST(Picture, that_was_stopped_before_it_began_is_none) {
    std::atomic<bool> stop = true;
    EXPECT_TRUE(picture_asked(asked(test::tetra_scene, 640, 480), 1, stop).result.stopped);
}

TEST(Picture, reads_nothing_outside_of_the_folder) {
    std::atomic<bool> stop = false;
    EXPECT_THROW((void)picture_asked(asked("include: \"/etc/passwd\"\n", 8, 8), 1, stop), Error);
    EXPECT_THROW((void)picture_asked(asked("include: \"../../a.pxm\"\n", 8, 8), 1, stop), Error);
}

Scene scene_of_text(const std::string& text) {
    Diagnostics diagnostics;
    Scene scene = parse_text("a.pxm", text, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << text;
    return scene;
}

TEST(ExactPoint, repeats_all_maps_in_turn_for_ever) {
    const Scene scene = scene_of_text(test::tetra_scene);
    const auto texts = decimal_texts(exact_point(scene, objects_of(scene).front(), {}));
    EXPECT_EQ(texts[0] + "," + texts[1] + "," + texts[2],
              attractor_point(scene, {"1", "2", "3", "4"}));
}

TEST(ExactPoint, lies_in_the_cell_of_its_word) {
    // The point of word w is the image under the maps of w of the point of no word.
    const Scene scene = scene_of_text(
        "ifs a { newmap scale: 0.5 translate: 1,0,0 newmap b scale: 0.25 rotate: z,90 }\n"
        "object o { ifs: a scale: 2 translate: 0,0,3 }");
    const ObjectBlock& object = scene.objects.front();
    const Affine place = compose(object.commands);
    const glm::dvec3 still = inverse(place).point(rounded(exact_point(scene, object, {})));
    glm::dvec3 expected = still;
    for (const std::size_t map : {1, 0, 1})
        expected = compose(scene.ifs[0].maps[map].commands).point(expected);
    const glm::dvec3 found = rounded(exact_point(scene, object, {1, 0, 1}));
    EXPECT_NEAR(glm::distance(found, place.point(expected)), 0, 1e-14);
}

TEST(ExactPoint, goes_on_with_what_the_graph_allows) {
    const Scene scene = scene_of_text(
        "ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 newmap scale: 0.5 "
        "translate: 0,1,0 follow: 1 -> 2 follow: 2 -> 3 follow: 3 -> 2, 3 start: 1 }\n"
        "object o { ifs: a }");
    // 1, then 2 3 2 3 ...: the point x of 2 3 has x = (x / 2 + (0, 1)) / 2 + (1, 0).
    const glm::dvec3 found = rounded(exact_point(scene, scene.objects.front(), {0}));
    EXPECT_NEAR(glm::distance(found, glm::dvec3(4.0 / 6, 2.0 / 6, 0)), 0, 1e-15);
}

TEST(PickedCell, is_what_the_frame_shows_of_the_pixel) {
    AskedPicture picture = asked(test::tetra_scene, 32, 24);
    const RenderRequest request = request_of(picture, 1);
    const CompiledScene scene = compiled_scene_of(request);
    const RenderResult result = render(request, {});
    int hits = 0, equal = 0;
    for (long y = 0; y < 24; ++y) {
        for (long x = 0; x < 32; ++x) {
            const auto picked = pick_cell(scene, x, y);
            const PixelRecord& pixel = result.frame.at(x, y);
            if (!picked || pixel.object < 0) continue;
            ++hits;
            if (picked->word.size() == static_cast<std::size_t>(pixel.level) &&
                std::abs(picked->distance - pixel.z) < 1e-4)
                ++equal;
        }
    }
    EXPECT_GT(hits, 50);
    EXPECT_EQ(equal, hits);
}

TEST(SceneView, is_the_camera_that_the_render_has) {
    std::atomic<bool> stop = false;
    for (const std::string& camera :
         {std::string(), std::string("camera { fov: 25 look: 0,0.1,0 }"),
          std::string("camera { eye: 1,2,-3 zoom: 1.5 }"),
          std::string("camera { orthographic: 3 }")}) {
        const std::string text = test::tetra_scene + camera;
        Diagnostics diagnostics;
        const SceneView view = view_of(scene_of_text(text), {48, 36}, diagnostics);
        AskedPicture as_is = asked(text, 48, 36);
        AskedPicture moved = as_is;
        const auto joined = [](const std::array<std::string, 3>& v) {
            return v[0] + "," + v[1] + "," + v[2];
        };
        moved.settings = {{"camera.eye", joined(view.eye)},
                          {"camera.look", joined(view.look)},
                          {"camera.zoom", std::to_string(view.zoom)}};
        EXPECT_EQ(png_bytes(picture_asked(as_is, 1, stop)),
                  png_bytes(picture_asked(moved, 1, stop)))
            << camera;
    }
}

TEST(SceneView, says_what_does_not_contract) {
    Diagnostics diagnostics;
    (void)view_of(scene_of_text("ifs a { newmap scale: 1.5 }"), {48, 36}, diagnostics);
    EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace pxm::host
