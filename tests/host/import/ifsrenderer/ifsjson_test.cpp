// IFSRenderer's files: iterators become the maps that its shader computes.
#include "host/import/ifsrenderer/ifsjson.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <random>
#include <string>
#include <variant>

#include "host/error.hpp"
#include "host/import/import.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {
namespace {

using testing::HasSubstr;

Imported imported(const std::string& text) { return import_ifsjson({"f.ifsjson", text}); }

struct Refusal {
    std::optional<ErrorKind> kind;
    std::string text;
};

Refusal refusal(const std::string& text) {
    try {
        (void)imported(text);
        return {};
    } catch (const Error& error) {
        return {error.kind(), error.what()};
    }
}

std::string vec(double x, double y, double z) {
    return "{\"X\":" + std::to_string(x) + ",\"Y\":" + std::to_string(y) +
           ",\"Z\":" + std::to_string(z) + "}";
}

std::string iterator(const std::string& name, const std::string& vectors,
                     const std::string& more = "", const std::string& reals = "") {
    return "{\"Transform\":{\"Item1\":\"" + name + "\",\"Item2\":\"1.1\"},\"RealParams\":{" +
           reals + "},\"Vec3Params\":{" + vectors + "}" + more + "}";
}

std::string affine(const glm::dvec3& move, double scale, const glm::dvec3& turn = {0, 0, 0},
                   const std::string& more = "") {
    return iterator("Affine",
                    "\"Translate\":" + vec(move.x, move.y, move.z) + ",\"Scale\":" +
                        vec(scale, scale, scale) + ",\"Rotate\":" + vec(turn.x, turn.y, turn.z),
                    more);
}

std::string file(const std::string& iterators, const std::string& more = "") {
    return "{\"Title\":\"T\",\"Iterators\":[" + iterators + "]" + more + "}";
}

glm::dvec3 image(const Imported& made, std::size_t i, const glm::dvec3& p) {
    return compose(made.scene.ifs[0].maps[i].commands).point(p);
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b) {
    EXPECT_NEAR(a.x, b.x, 1e-6);
    EXPECT_NEAR(a.y, b.y, 1e-6);
    EXPECT_NEAR(a.z, b.z, 1e-6);
}

const double cos30 = std::cos(std::acos(-1.0) / 6);

TEST(IfsRenderer, affine_turns_then_scales_then_moves) {
    const Imported made = imported(file(affine({1, 2, 3}, 0.5, {0, 0, 90})));
    EXPECT_EQ(made.name, "T");
    expect_near(image(made, 0, {1, 0, 0}), {1, 2.5, 3});  // its rotate turns x toward y
    const Imported both = imported(file(affine({0, 0, 0}, 0.5, {90, 0, 90})));
    // About x first: z goes to -y, which the turn about z takes to x.
    expect_near(image(both, 0, {0, 0, 1}), {0.5, 0, 0});
}

TEST(IfsRenderer, rotate_euler_turns_the_other_way) {
    const Imported made = imported(file(
        iterator("Rotate Euler", "\"EulerAngles\":" + vec(0, 0, 30), ",\"Mix\":0.5,\"Add\":-0.5")));
    expect_near(image(made, 0, {1, 0, 0}), {0.25 + cos30 / 2, -0.25, 0});
}

TEST(IfsRenderer, transforms_are_mixed_with_their_point) {
    const Imported made =
        imported(file(affine({1, 0, 0}, 0.5, {0, 0, 0}, ",\"Mix\":0.5,\"Add\":-0.5")));
    // p + 0.5 (T(p) - 0.5 p - p) with T(p) = p / 2 + (1, 0, 0)
    expect_near(image(made, 0, {2, 4, 6}),
                {2 + 0.5 * (2 - 1 - 2), 4 + 0.5 * (2 - 2 - 4), 6 + 0.5 * (3 - 3 - 6)});
}

TEST(IfsRenderer, scale_center_keeps_its_centre) {
    const Imported made = imported(
        file(iterator("Scale Center", "\"Center\":" + vec(1, 2, 3), "", "\"Scale\":0.25")));
    expect_near(image(made, 0, {1, 2, 3}), {1, 2, 3});
    expect_near(image(made, 0, {5, 2, 3}), {2, 2, 3});
}

TEST(IfsRenderer, xaos_says_what_comes_after_and_opacity_what_is_shown) {
    const Imported made = imported(
        file(affine({0, 0, 0}, 0.5) + "," + affine({1, 0, 0}, 0.5, {0, 0, 0}, ",\"Opacity\":0"),
             ",\"xaos\":[[0,1],[1,1]]"));
    const IfsBlock& ifs = made.scene.ifs[0];
    ASSERT_EQ(ifs.follow.size(), 2U);
    ASSERT_EQ(ifs.follow[0].followers.size(), 1U);
    EXPECT_EQ(std::get<std::string>(ifs.follow[0].followers[0].map), "iterator_2");
    ASSERT_EQ(ifs.start.size(), 1U);
    EXPECT_EQ(std::get<std::string>(ifs.start[0].map), "iterator_1");
}

TEST(IfsRenderer, colours_are_the_palettes) {
    const Imported made =
        imported(file(affine({0, 0, 0}, 0.5, {0, 0, 0}, ",\"ColorIndex\":0.5,\"ColorSpeed\":1"),
                      ",\"Palette\":{\"Colors\":[" + vec(1, 0, 0) + "," + vec(0, 1, 0) + "," +
                          vec(0, 0, 1) + "]}"));
    EXPECT_EQ(made.scene.ifs[0].maps[0].color, glm::dvec4(0, 1, 0, 1));
}

TEST(IfsRenderer, its_camera_looks_along_z) {
    const Imported made = imported(
        file(affine({0, 0, 0}, 0.5) + "," + affine({1, 0, 0}, 0.5),
             ",\"ImageResolution\":\"320, 200\",\"Camera\":{\"Position\":" + vec(0, 0, -5) +
                 ",\"Orientation\":{\"X\":0,\"Y\":0,\"Z\":0,\"W\":1},\"FieldOfView\":59}"));
    EXPECT_EQ((*made.scene.camera->look)[2].value, -4);
    EXPECT_EQ(*made.scene.camera->fov, 60);
    EXPECT_EQ(made.scene.image->size->rows, 200);
}

TEST(IfsRenderer, what_is_not_affine_is_refused_by_name) {
    const Refusal refused = refusal(file(affine({0, 0, 0}, 0.5) + "," + iterator("Spherical", "")));
    EXPECT_EQ(refused.kind, ErrorKind::scene);
    EXPECT_THAT(refused.text, HasSubstr("f.ifsjson: iterator 2: the transform \"Spherical\" is "
                                        "not affine, or not known"));
}

TEST(IfsRenderer, hostile_files_end_in_a_message) {
    for (const std::string& bad :
         {std::string(), std::string("{}"), std::string("[]"), std::string(200'000, '['),
          std::string("{\"Iterators\":") + std::string(1'000'000, '['),
          std::string("{\"Iterators\":3}"), file("3"), file("{}"), file(affine({0, 0, 0}, 2)),
          file(affine({0, 0, 0}, 0.5), ",\"xaos\":[[1,1]]"),
          file(affine({0, 0, 0}, 0.5), ",\"xaos\":[[0]]"),
          file(affine({0, 0, 0}, 0.5), ",\"xaos\":[[-1]]"),
          file(affine({0, 0, 0}, 0.5, {0, 0, 0}, ",\"Mix\":1e999")),
          file(affine({0, 0, 0}, 0.5, {0, 0, 0}, ",\"Mix\":\"x\"")), file("")})
        EXPECT_EQ(refusal(bad).kind, ErrorKind::scene) << bad.substr(0, 80);
}

TEST(IfsRenderer, a_file_cut_anywhere_is_one_message) {
    const std::string whole = file(affine({0, 0, 0}, 0.5), ",\"xaos\":[[1]]");
    for (std::size_t end = 0; end < whole.size(); ++end)
        EXPECT_EQ(refusal(whole.substr(0, end)).kind, ErrorKind::scene) << end;
}

TEST(IfsRenderer, any_bytes_end_in_a_scene_or_a_message) {
    const std::string alphabet = "{}[]\":,.-+0123456789eXtrue\\\n\x80\x01";
    const std::string whole =
        file(affine({0, 0, 0}, 0.5) + "," + affine({1, 0, 0}, 0.5), ",\"xaos\":[[1,1],[1,0]]");
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937 random(seed);
        std::string text = whole;
        for (int i = 0; i < 3; ++i)
            text[random() % text.size()] = alphabet[random() % alphabet.size()];
        const Refusal refused = refusal(text);
        EXPECT_TRUE(!refused.kind || refused.kind == ErrorKind::scene) << text << refused.text;
    }
}

}  // namespace
}  // namespace pxm::host
