// The laws of host/studio/asks_json.hpp: a question is what the page sends, and asks for no more
// than there is.
#include "host/studio/asks_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/error.hpp"

namespace pxm::host {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

Json question() {
    return {{"view", "abc-picture"}, {"serial", 3},    {"name", "a.pxm"},
            {"text", "ifs a {}"},    {"columns", 640}, {"rows", 480},
            {"samples", 4},          {"machine", ""},  {"settings", {"camera.zoom=2"}}};
}

std::string refusal_of(const std::string& body) {
    try {
        (void)asked_picture(body);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::setting);
        return error.what();
    }
    return "";
}

std::string refusal_with(const char* key, const Json& value) {
    Json changed = question();
    changed[key] = value;
    return refusal_of(changed.dump());
}

TEST(AsksJson, a_question_is_read) {
    const AskedPicture asked = asked_picture(question().dump());
    EXPECT_EQ(asked.scene.asking.view, "abc-picture");
    EXPECT_EQ(asked.scene.asking.serial, 3U);
    EXPECT_EQ(asked.scene.name, "a.pxm");
    EXPECT_EQ(asked.scene.text, "ifs a {}");
    EXPECT_EQ(asked.size, (PixelSize{640, 480}));
    EXPECT_EQ(asked.samples, 4);
    EXPECT_EQ(asked.settings, (Settings{{"camera.zoom", "2"}}));
    EXPECT_EQ(asked.machine, nullptr);
    Json machine = question();
    machine["machine"] = "964dX";
    EXPECT_EQ(asked_picture(machine.dump()).machine->name, "964dX");
}

TEST(AsksJson, what_is_no_question_is_refused) {
    for (const std::string& body :
         {std::string(), std::string("x"), std::string("[]"), std::string("null"), std::string("{"),
          std::string("\xFF"), std::string("{}{}"), std::string(100'000, '['),
          std::string("{\"a\":") + std::string(50, '[') + std::string(50, ']') + "}"})
        EXPECT_EQ(refusal_of(body), "the question: expected a JSON object") << body.substr(0, 20);
    const Json whole = question();
    for (const auto& [key, value] : whole.items()) {
        Json less = whole;
        less.erase(key);
        EXPECT_EQ(refusal_of(less.dump()).empty(), key == "settings") << key;
        EXPECT_NE(refusal_with(key.c_str(), Json::object()), "") << key;
        EXPECT_NE(refusal_with(key.c_str(), nullptr), "") << key;
    }
}

TEST(AsksJson, numbers_have_limits) {
    for (const char* key : {"columns", "rows"})
        for (const Json& value : {Json(0), Json(-1), Json(4097), Json(1e300), Json(0.5),
                                  Json(18446744073709551615U), Json("640")})
            EXPECT_THAT(refusal_with(key, value), HasSubstr(key)) << value;
    Json square = question();
    square["columns"] = square["rows"] = 4096;
    EXPECT_EQ(refusal_of(square.dump()), "columns, rows: expected at most 4194304 pixels");
    EXPECT_THAT(refusal_with("samples", 65), HasSubstr("0 to 64"));
    EXPECT_THAT(refusal_with("serial", 0), HasSubstr("serial"));
    EXPECT_THAT(refusal_with("frame", 1'000'000), HasSubstr("frame"));
    EXPECT_THAT(refusal_with("text", std::string(asked_text_bytes + 1, ' ')),
                HasSubstr("at most 1048576 bytes"));
}

TEST(AsksJson, a_name_leads_nowhere_else) {
    for (const char* name : {"", "../a.pxm", "/a.pxm", "a", "a/../b.pxm", "a\u0000.pxm"})
        EXPECT_NE(refusal_with("name", name), "") << name;
    for (const char* view : {"", "a b", "<script>", "../x"})
        EXPECT_THAT(refusal_with("view", view), HasSubstr("view")) << view;
    EXPECT_THAT(refusal_with("view", std::string(41, 'a')), HasSubstr("view"));
    EXPECT_EQ(refusal_with("machine", "965"), "machine: expected the name of a model");
}

TEST(AsksJson, settings_are_of_the_camera_and_the_rendering) {
    EXPECT_EQ(refusal_with("settings", {"render.shading=facet"}), "");
    for (const char* setting : {"texture.a.file=\"/etc/passwd\"", "height=3", "image.size=9,9",
                                "object.levels=1", "ifs.a.start=1", "camera"})
        EXPECT_NE(refusal_with("settings", {setting}), "") << setting;
    EXPECT_NE(refusal_with("settings", Json(std::vector<std::string>(17, "camera.zoom=1"))), "");
    EXPECT_NE(refusal_with("settings", {"camera.zoom=" + std::string(600, '1')}), "");
}

TEST(AsksJson, a_pixel_lies_in_the_picture) {
    Json pixel = question();
    pixel["x"] = 639;
    pixel["y"] = 479;
    EXPECT_EQ(asked_pixel(pixel.dump()).x, 639);
    pixel["x"] = 640;
    EXPECT_THROW((void)asked_pixel(pixel.dump()), Error);
}

TEST(AsksJson, a_check_may_say_how_large_the_picture_is) {
    EXPECT_EQ(asked_check(question().dump()).size, (PixelSize{640, 480}));
    Json bare = question();
    bare.erase("columns");
    EXPECT_THROW((void)asked_check(bare.dump()), Error) << "one of two";
    bare.erase("rows");
    EXPECT_EQ(asked_check(bare.dump()).size, std::nullopt);
    bare["columns"] = bare["rows"] = 1'000'000;
    EXPECT_THROW((void)asked_check(bare.dump()), Error);
}

TEST(AsksJson, a_file_comes_as_base64_and_a_study_is_small) {
    const Json file = {{"view", "a"}, {"serial", 1}, {"name", "x.ifs"}, {"data", "TWFu"}};
    EXPECT_EQ(asked_import(file.dump()).file.bytes, "Man");
    for (const auto& [key, value] : {std::pair{"data", Json("<>")}, std::pair{"name", Json(3)},
                                     std::pair{"maps", Json(100)}, std::pair{"entry", Json(7)}}) {
        Json wrong = file;
        wrong[key] = value;
        EXPECT_THROW((void)asked_import(wrong.dump()), Error) << key;
    }
    Json study = question();
    study["columns"] = study["rows"] = 64;
    study["kind"] = "balance";
    EXPECT_EQ(asked_study(study.dump()).kind, StudyKind::balance);
    study["kind"] = "../balance";
    EXPECT_THROW((void)asked_study(study.dump()), Error);
    study["kind"] = "error";
    study["rows"] = 3000;
    EXPECT_THROW((void)asked_study(study.dump()), Error);
}

}  // namespace
}  // namespace pxm::host
