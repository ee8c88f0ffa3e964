#include "host/scene/carried/carried_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "host/files/carried_text.hpp"
#include "host/scene/check/limits.hpp"
#include "host/text/json_text.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_name = 1024;  // bytes
constexpr std::size_t most_options = 1000;

bool is_utf8(const std::string& text) {
    try {
        (void)Json(text).dump();
        return true;
    } catch (const Json::exception&) {
        return false;
    }
}

/// Bytes that are no UTF-8, each as the letter that Latin-1 has for it.
std::string as_latin1(const std::string& bytes) {
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            text += c;
        } else {
            text += static_cast<char>(0xc0U | byte >> 6U);
            text += static_cast<char>(0x80U | (byte & 0x3fU));
        }
    }
    return text;
}

std::string of_latin1(const std::string& text) {
    std::string bytes;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const auto first = static_cast<unsigned char>(text[at]);
        if (first < 0x80) {
            bytes += text[at];
        } else {
            if (first > 0xc3 || at + 1 == text.size()) throw std::invalid_argument("no Latin-1");
            const auto second = static_cast<unsigned char>(text[++at]);
            bytes += static_cast<char>((first & 3U) << 6U | (second & 0x3fU));
        }
    }
    return bytes;
}

Json file_json(const SourceFile& file) {
    if (is_utf8(file.text)) return {{"name", file.name}, {"text", file.text}};
    return {{"name", file.name}, {"latin1", as_latin1(file.text)}};
}

SourceFile file_of(const Json& json) {
    const bool plain = json.contains("text");
    return {json.at("name"), plain ? json.at("text").get<std::string>()
                                   : of_latin1(json.at("latin1").get<std::string>())};
}

Json json_of(const CarriedScene& carried) {
    Json json{{"pxm", carried.version}};
    if (!carried.left_out.empty()) {
        json["left_out"] = carried.left_out;
        return json;
    }
    json["files"] = Json::array();
    for (const SourceFile& file : carried.files) json["files"].push_back(file_json(file));
    json["pictures"] = Json::array();
    for (const CarriedPicture& picture : carried.pictures)
        json["pictures"].push_back({picture.name, picture.digest});
    json["options"] = Json::array();
    for (const auto& [name, value] : carried.options) json["options"].push_back({name, value});
    return json;
}

/// Names start at the scene's folder, and stand in messages.
void require_name(const std::string& name) {
    const bool shown =
        !name.empty() && name.size() <= longest_name && printable(name, longest_name) == name;
    if (!shown || std::filesystem::path(name).is_absolute())
        throw std::invalid_argument("a file has no such name");
}

void require_sound(const CarriedScene& carried) {
    if (carried.files.empty() || carried.files.size() > files_a_scene)
        throw std::invalid_argument("so many files have no scene");
    std::set<std::string> names;
    for (const SourceFile& file : carried.files) {
        require_name(file.name);
        if (!names.insert(file.name).second) throw std::invalid_argument("two files, one name");
    }
    if (carried.pictures.size() > pictures_a_scene) throw std::invalid_argument("many pictures");
    for (const CarriedPicture& picture : carried.pictures) require_name(picture.name);
    if (carried.options.size() > most_options) throw std::invalid_argument("many options");
}

}  // namespace

std::string carried_json(CarriedScene& carried) {
    std::size_t bytes = 0;
    for (const SourceFile& file : carried.files) bytes += file.text.size();
    std::string text;
    if (bytes <= carried_bytes) text = json_text(json_of(carried));
    if (!text.empty() && text.size() <= carried_bytes) return text;
    carried.left_out = fmt::format("it was larger than {} bytes", carried_bytes);
    return json_text(json_of(carried));
}

bool is_carried_name(const std::string& name) {
    return !name.empty() && name.size() <= longest_name && printable(name, longest_name) == name &&
           !std::filesystem::path(name).is_absolute();
}

CarriedScene carried_of_json(const std::string& text) {
    const Json json = Json::parse(text);
    CarriedScene carried;
    carried.version = json.at("pxm");
    if (json.contains("left_out")) {
        carried.left_out = json.at("left_out");
        return carried;
    }
    for (const Json& file : json.at("files")) carried.files.push_back(file_of(file));
    for (const Json& picture : json.at("pictures"))
        carried.pictures.push_back({picture.at(0), picture.at(1)});
    for (const Json& option : json.at("options"))
        carried.options.emplace_back(option.at(0), option.at(1));
    require_sound(carried);
    carried.has_frames = !carried.values_of("--frames").empty();
    return carried;
}

}  // namespace pxm::host
