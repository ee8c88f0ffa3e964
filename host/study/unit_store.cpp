#include "host/study/unit_store.hpp"

#include <filesystem>
#include <system_error>

#include "host/error.hpp"
#include "host/files/new_folder.hpp"
#include "host/files/regular_file.hpp"
#include "host/files/safe_file.hpp"
#include "host/text/json_text.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

using Json = nlohmann::ordered_json;

std::string UnitStore::path(const std::string& name) const {
    return folder_ + "/" + name + ".json";
}

void UnitStore::require_place(const std::string& name) const {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path(name), error);
    if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
    throw Error(ErrorKind::file, printable_path(path(name)) + ": not a regular file");
}

std::optional<Json> UnitStore::find(const std::string& name, const Json& settings) const {
    std::string text;
    try {
        text = read_file(path(name));
    } catch (const Error&) {
        return std::nullopt;
    }
    const Json stored = Json::parse(text, nullptr, false);
    if (!stored.is_object() || !stored.contains("settings") || !stored.contains("result"))
        return std::nullopt;
    // As text: a number read back is the same text, whatever type it was made from.
    if (json_text(stored["settings"]) != json_text(settings)) return std::nullopt;
    return stored["result"];
}

void UnitStore::put(const std::string& name, const Json& settings, const Json& result) {
    const std::error_code error = make_folders(folder_);
    if (error) {
        throw Error(ErrorKind::file,
                    "cannot make the folder " + printable_path(folder_) + ": " + error.message());
    }
    write_text_safely(path(name), json_text({{"settings", settings}, {"result", result}}) + "\n");
}

}  // namespace pxm::host
