#include "host/studio/scene_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "host/error.hpp"
#include "host/files/regular_file.hpp"
#include "host/files/safe_file.hpp"
#include "host/text/digest.hpp"
#include "host/text/printable.hpp"
#include "host/text/without.hpp"

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 200;  // bytes
constexpr int deepest = 4;                 // folders within folders that are looked through

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
    throw Error(ErrorKind::setting, fmt::format("\"{}\": {}", printable(name, longest_name), why));
}

bool is_visible(const std::string& part) {
    const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7F || c == '\\'; };
    return !part.empty() && part.front() != '.' && std::ranges::none_of(part, is_control);
}

void require_parts(const std::string& name) {
    std::size_t begin = 0;
    while (begin <= name.size()) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        if (!is_visible(name.substr(begin, end - begin)))
            refuse(name, "expected a name below the studio's folder, without hidden parts");
        begin = end + 1;
    }
}

void require_below(const std::string& name) {
    if (name.empty() || name.size() > longest_name || name.front() == '/')
        refuse(name, "expected a name below the studio's folder");
    require_parts(name);
}

std::string digest_text(const std::string& text) { return fmt::format("{:016x}", digest_of(text)); }

}  // namespace

SceneFolder::SceneFolder(const std::string& path) {
    std::error_code error;
    root_ = fs::canonical(path, error);
    if (error) throw Error(ErrorKind::file, path + ": " + error.message());
    if (!fs::is_directory(root_)) throw Error(ErrorKind::file, path + ": is no folder");
}

void SceneFolder::require_name(const std::string& name) {
    require_below(name);
    if (!name.ends_with(".pxm")) refuse(name, "expected a name that ends in .pxm");
}

fs::path SceneFolder::scene_place(const std::string& name) const {
    require_name(name);
    return place_of(name);
}

fs::path SceneFolder::place_of(const std::string& name) const {
    require_below(name);
    fs::path place = root_;
    const fs::path relative(name);
    for (const fs::path& part : relative) {
        std::error_code error;
        const fs::file_status folder = fs::symlink_status(place, error);
        if (error || folder.type() != fs::file_type::directory)
            throw Error(ErrorKind::file, name + ": its folder is not there, or is a link");
        place /= part;
    }
    std::error_code error;
    if (fs::symlink_status(place, error).type() == fs::file_type::symlink)
        throw Error(ErrorKind::file, name + ": is a link");
    return place;
}

std::string SceneFolder::told(const std::string& message) const {
    return without(message, root_.string() + "/");
}

std::vector<std::string> SceneFolder::scenes() const {
    std::vector<std::string> names;
    std::error_code error;
    constexpr auto options = fs::directory_options::skip_permission_denied;
    fs::recursive_directory_iterator at(root_, options, error);
    constexpr int most_looked_at = 20'000;
    for (int looked = 0; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
        if (++looked > most_looked_at || names.size() == most_scenes) break;
        const bool visible = is_visible(at->path().filename().string());
        std::error_code unknown;
        if (at->is_directory(unknown) && (!visible || at.depth() >= deepest))
            at.disable_recursion_pending();
        if (!visible || at->path().extension() != ".pxm") continue;
        if (at->symlink_status(unknown).type() != fs::file_type::regular) continue;
        names.push_back(at->path().lexically_relative(root_).generic_string());
    }
    std::ranges::sort(names);
    return names;
}

SceneFile SceneFolder::open(const std::string& name) const {
    const RegularFile file(scene_place(name).string(), name);
    if (file.bytes() > scene_bytes)
        throw Error(ErrorKind::file, fmt::format("{}: the studio opens scenes of up to {} bytes",
                                                 name, scene_bytes));
    SceneFile scene;
    scene.text = file.read(0, scene_bytes);
    scene.digest = digest_text(scene.text);
    return scene;
}

Saved SceneFolder::save(const std::string& name, const std::string& text,
                        const std::string& seen) const {
    const fs::path place = scene_place(name);
    std::string now;
    if (fs::exists(fs::symlink_status(place))) now = open(name).digest;
    if (now == digest_text(text)) return Saved::done;
    if (now != seen) return Saved::changed;
    write_text_safely(place.string(), text);
    return Saved::done;
}

}  // namespace pxm::host
