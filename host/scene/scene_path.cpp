#include "host/scene/scene_path.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include "host/files/installed_places.hpp"
#include "host/text/nearest.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view extension = ".pxm";
constexpr std::size_t most_names = 10'000;  // of a folder: more are not looked at

bool is_there(const fs::path& path) {
    std::error_code failed;
    return fs::exists(path, failed);
}

bool is_file(const fs::path& path) {
    std::error_code failed;
    return fs::is_regular_file(path, failed);
}

/// Whether it leads to something below any folder that it is put behind.
bool is_below(const fs::path& path) {
    return path.is_relative() && !path.empty() && *path.lexically_normal().begin() != "..";
}

std::optional<FoundScene> find_in_folders(const std::string& name) {
    const fs::path written(name);
    if (!is_below(written)) return std::nullopt;
    for (const std::string& folder : scene_folders()) {
        const fs::path path = (fs::path(folder) / written).lexically_normal();
        if (is_file(path)) return FoundScene{path.string(), folder};
    }
    return std::nullopt;
}

/// Calls `take` with the paths of the scenes below a folder, or beside one another in it.
template <class Iterator, class Take>
void for_scenes_in(const fs::path& folder, const Take& take) {
    std::error_code failed;
    std::size_t seen = 0;
    const auto options = fs::directory_options::skip_permission_denied;
    for (Iterator entry(folder, options, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        if (++seen > most_names) return;
        if (entry->path().extension() == extension) take(entry->path());
    }
}

std::string without_extension(const fs::path& path) {
    return (path.parent_path() / path.stem()).string();
}

}  // namespace

std::vector<std::string> scene_folders() {
    std::vector<std::string> folders;
    const char* variable = std::getenv("PXM_SCENE_PATH");
    const std::string path = variable == nullptr ? "" : variable;
    for (std::size_t from = 0; from < path.size();) {
        const std::size_t colon = std::min(path.find(':', from), path.size());
        if (colon > from) folders.push_back(path.substr(from, colon - from));
        from = colon + 1;
    }
    for (const fs::path& data : data_folders()) {
        const fs::path scenes = data / "scenes";
        if (!is_there(scenes)) continue;
        folders.push_back(scenes.string());
        break;
    }
    return folders;
}

std::optional<FoundScene> find_scene(const std::string& name) {
    if (name.empty()) return std::nullopt;
    if (is_there(name)) return FoundScene{name, ""};
    const std::string with_extension = name + std::string(extension);
    if (is_file(with_extension)) return FoundScene{with_extension, ""};
    auto found = find_in_folders(with_extension);
    return found ? found : find_in_folders(name);
}

std::optional<FoundScene> find_included(const std::string& written) {
    return find_in_folders(written);
}

std::vector<std::string> scene_names() {
    std::set<std::string> names;
    for (const std::string& folder : scene_folders()) {
        for_scenes_in<fs::recursive_directory_iterator>(folder, [&](const fs::path& path) {
            names.insert(without_extension(path.lexically_relative(folder)));
        });
    }
    return {names.begin(), names.end()};
}

std::string suggest_scene(const std::string& missing) {
    const fs::path path(missing);
    std::vector<std::string> names;
    if (is_below(path)) names = scene_names();
    std::vector<std::string_view> known(names.begin(), names.end());
    const std::string by_name = suggestion(without_extension(path), known);
    if (!by_name.empty() || !path.has_filename()) return by_name;
    std::vector<std::string> beside;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    for_scenes_in<fs::directory_iterator>(
        folder, [&](const fs::path& scene) { beside.push_back(scene.filename().string()); });
    std::ranges::sort(beside);
    known.assign(beside.begin(), beside.end());
    const std::string_view near = nearest(path.filename().string(), known);
    if (near.empty()) return {};
    return " (did you mean '" + printable((path.parent_path() / near).string(), 400) + "'?)";
}

}  // namespace pxm::host
