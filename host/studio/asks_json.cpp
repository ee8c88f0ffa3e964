#include "host/studio/asks_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "host/error.hpp"
#include "host/scene/check/limits.hpp"
#include "host/studio/scene_folder.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_settings = 16;
constexpr std::size_t setting_bytes = 600;

[[noreturn]] void refuse(const std::string& what, const std::string& expected) {
    throw Error(ErrorKind::setting, fmt::format("{}: expected {}", what, expected));
}

Json parsed(const std::string& body) {
    // A depth that no question has would cost the parser's stack.
    constexpr int deepest = 8;
    bool deep = false;
    const auto look = [&](int depth, Json::parse_event_t, Json&) {
        deep = deep || depth > deepest;
        return !deep;
    };
    Json json = Json::parse(body, look, false);
    if (deep || !json.is_object()) refuse("the question", "a JSON object");
    return json;
}

std::string text_at(const Json& json, const char* key, std::size_t most) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_string()) refuse(key, "a text");
    auto text = found->get<std::string>();
    if (text.size() > most) refuse(key, fmt::format("at most {} bytes", most));
    return text;
}

long whole_at(const Json& json, const char* key, long low, long high) {
    const auto found = json.find(key);
    const bool is_whole = found != json.end() && found->is_number_integer();
    if (!is_whole || *found < low || *found > high)
        refuse(key, fmt::format("a whole number of {} to {}", low, high));
    return found->get<long>();
}

/// Letters and digits, and not too many: it names a page in tables.
std::string view_at(const Json& json) {
    constexpr std::size_t longest = 40;
    const std::string view = text_at(json, "view", longest);
    const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-'; };
    if (view.empty() || !std::ranges::all_of(view, plain)) refuse("view", "letters and digits");
    return view;
}

Asking asking_of(const Json& json) {
    constexpr long largest_serial = 1L << 52;
    return {view_at(json), static_cast<std::uint64_t>(whole_at(json, "serial", 1, largest_serial))};
}

AskedScene scene_of(const Json& json) {
    AskedScene asked;
    asked.asking = asking_of(json);
    asked.name = text_at(json, "name", setting_bytes);
    SceneFolder::require_name(asked.name);
    asked.text = text_at(json, "text", asked_text_bytes);
    if (json.contains("frame"))
        asked.frame = static_cast<double>(whole_at(json, "frame", 0, frames_a_film - 1));
    return asked;
}

/// Settings move the camera and choose how to render; what the scene is, its text says.
Setting setting_of(const Json& json) {
    if (!json.is_string()) refuse("settings", "texts KEY=VALUE");
    const auto text = json.get<std::string>();
    if (text.size() > setting_bytes)
        refuse("settings", fmt::format("at most {} bytes each", setting_bytes));
    const Setting setting = parse_setting(text);
    if (!setting.key.starts_with("camera.") && !setting.key.starts_with("render."))
        refuse("settings", "those of the camera and the render block");
    return setting;
}

AskedPicture picture_of(const Json& json) {
    AskedPicture asked;
    asked.scene = scene_of(json);
    const Json settings = json.value("settings", Json::array());
    if (!settings.is_array() || settings.size() > most_settings)
        refuse("settings", fmt::format("a list of at most {}", most_settings));
    for (const Json& one : settings) asked.settings.push_back(setting_of(one));
    asked.size = {whole_at(json, "columns", 1, asked_side_pixels),
                  whole_at(json, "rows", 1, asked_side_pixels)};
    if (asked.size.columns * asked.size.rows > asked_pixels)
        refuse("columns, rows", fmt::format("at most {} pixels", asked_pixels));
    asked.samples = whole_at(json, "samples", 0, asked_samples);
    const std::string machine = text_at(json, "machine", setting_bytes);
    if (!machine.empty()) {
        asked.machine = find_model(machine);
        if (asked.machine == nullptr) refuse("machine", "the name of a model");
    }
    return asked;
}

}  // namespace

std::string asked_view(const std::string& body) { return view_at(parsed(body)); }

AskedScene asked_scene(const std::string& body) { return scene_of(parsed(body)); }

AskedPicture asked_picture(const std::string& body) { return picture_of(parsed(body)); }

AskedPixel asked_pixel(const std::string& body) {
    const Json json = parsed(body);
    AskedPixel asked;
    asked.picture = picture_of(json);
    asked.x = whole_at(json, "x", 0, asked.picture.size.columns - 1);
    asked.y = whole_at(json, "y", 0, asked.picture.size.rows - 1);
    return asked;
}

AskedFile asked_file(const std::string& body) {
    const Json json = parsed(body);
    AskedFile asked;
    asked.name = text_at(json, "name", setting_bytes);
    if (json.contains("text")) asked.text = text_at(json, "text", asked_text_bytes);
    if (json.contains("seen")) asked.seen = text_at(json, "seen", setting_bytes);
    return asked;
}

AskedCheck asked_check(const std::string& body) {
    const Json json = parsed(body);
    AskedCheck asked{scene_of(json), {}};
    if (json.contains("columns") || json.contains("rows"))
        asked.size = {whole_at(json, "columns", 1, asked_side_pixels),
                      whole_at(json, "rows", 1, asked_side_pixels)};
    return asked;
}

AskedImport asked_import(const std::string& body) {
    const Json json = parsed(body);
    AskedImport asked;
    asked.asking = asking_of(json);
    asked.file.name = text_at(json, "name", setting_bytes);
    auto bytes = bytes_of_base64(text_at(json, "data", brought_bytes * 4 / 3 + 4));
    if (!bytes) refuse("data", "a file's bytes in base64");
    asked.file.bytes = *std::move(bytes);
    if (json.contains("entry")) asked.file.entry = text_at(json, "entry", setting_bytes);
    constexpr long most_maps = 8;
    if (json.contains("maps"))
        asked.file.maps = static_cast<int>(whole_at(json, "maps", 2, most_maps));
    return asked;
}

AskedStudy asked_study(const std::string& body) {
    const Json json = parsed(body);
    AskedStudy asked;
    asked.scene = scene_of(json);
    const std::string kind = text_at(json, "kind", setting_bytes);
    if (kind != "balance" && kind != "error") refuse("kind", "balance or error");
    asked.kind = kind == "balance" ? StudyKind::balance : StudyKind::error;
    constexpr long side = 320;
    asked.size = {whole_at(json, "columns", 1, side), whole_at(json, "rows", 1, side)};
    return asked;
}

AskedExport asked_export(const std::string& body) {
    const Json json = parsed(body);
    AskedExport asked;
    asked.scene = scene_of(json);
    asked.file = text_at(json, "file", setting_bytes);
    constexpr long most_levels = 1000;
    if (json.contains("levels")) asked.levels = whole_at(json, "levels", 0, most_levels);
    if (json.contains("detail")) {
        if (!json["detail"].is_number() || !(json["detail"] > 0))
            refuse("detail", "a length greater than 0");
        asked.detail = json["detail"].get<double>();
    }
    asked.replaces = json.value("replaces", Json(false)) == true;
    return asked;
}

}  // namespace pxm::host
