#include "host/files/allowed_folders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "host/error.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_folder = 400;

/// As it is kept: what lies below starts with it.
std::string start_of(const fs::path& folder) {
    std::string text = folder.string();
    if (!text.ends_with('/')) text += '/';
    return text;
}

/// A folder as a word of a shell's command line.
std::string shell_word(const fs::path& folder) {
    const std::string text = folder.string();
    const auto plain = [](unsigned char c) {
        return std::isalnum(c) != 0 ||
               std::string_view("/._-+,@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (std::ranges::all_of(text, plain)) return text;
    std::string quoted = "'";
    for (const char c : printable(text, longest_folder)) {
        quoted += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
    }
    return quoted + "'";
}

}  // namespace

AllowedFolders::AllowedFolders(const std::string& scene_path,
                               const std::vector<std::string>& allowed) {
    std::error_code failed;
    // A text in memory may have no name: then it lies in the folder that one is in.
    const fs::path whole = fs::current_path(failed) / scene_path;
    const fs::path own = fs::weakly_canonical(whole.parent_path(), failed);
    if (failed) throw Error(ErrorKind::file, fmt::format("{}: cannot be opened", scene_path));
    folders_.push_back(start_of(own));
    for (const std::string& folder : allowed) {
        const fs::path place = fs::canonical(folder, failed);
        if (failed || !fs::is_directory(place, failed))
            throw Error(ErrorKind::setting, fmt::format("--allow: found \"{}\", expected a folder",
                                                        printable(folder, longest_folder)));
        folders_.push_back(start_of(place));
    }
}

void AllowedFolders::allow(const std::string& folder) {
    std::error_code failed;
    const fs::path place = fs::canonical(folder, failed);
    if (!failed && !folders_.empty()) folders_.push_back(start_of(place));
}

std::string AllowedFolders::resolved(const std::string& path) const {
    if (folders_.empty()) return path;
    std::error_code failed;
    const fs::path place = fs::weakly_canonical(fs::absolute(path), failed);
    if (failed) throw Error(ErrorKind::file, fmt::format("{}: cannot be opened", path));
    const bool inside = std::ranges::any_of(
        folders_, [&](const std::string& start) { return place.string().starts_with(start); });
    if (inside) return place.string();
    throw Error(ErrorKind::file,
                fmt::format("{}: lies outside the scene's folder; if you trust the scene, add "
                            "--allow {}",
                            path, shell_word(place.parent_path())));
}

}  // namespace pxm::host
