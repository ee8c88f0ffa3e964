// /proc/self/cgroup names the process's group in each hierarchy, /proc/self/mountinfo where a
// hierarchy is mounted and from which group on.
#include "host/process/control_group.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

bool holds(const std::string& list, const char* word) {
    const std::vector<std::string> words = split(list, ',');
    return std::ranges::find(words, word) != words.end();
}

/// The process's group in the hierarchy of the controller; lines are `id:controllers:path`.
std::optional<std::string> group_of(const fs::path& root, GroupVersion version,
                                    const char* controller) {
    std::ifstream file(root / "proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        if (version == GroupVersion::two ? controllers.empty() : holds(controllers, controller))
            return line.substr(second + 1);
    }
    return std::nullopt;
}

struct Mount {
    fs::path group;  // the part of the hierarchy that is seen there
    fs::path place;
};

/// Lines are `id parent device ROOT PLACE options [tags] - TYPE source OPTIONS`.
std::optional<Mount> mount_of(const fs::path& root, GroupVersion version, const char* controller) {
    std::ifstream file(root / "proc/self/mountinfo");
    for (std::string line; std::getline(file, line);) {
        const std::vector<std::string> words = split(line, ' ');
        const auto dash = std::ranges::find(words, "-");
        if (words.end() - dash < 4 || dash - words.begin() < 5) continue;
        const bool found = version == GroupVersion::two
                               ? dash[1] == "cgroup2"
                               : dash[1] == "cgroup" && holds(dash[3], controller);
        if (found) return Mount{words[3], root / fs::path(words[4]).relative_path()};
    }
    return std::nullopt;
}

}  // namespace

std::vector<fs::path> group_folders(const fs::path& root, GroupVersion version,
                                    const char* controller) {
    const auto group = group_of(root, version, controller);
    const auto mount = mount_of(root, version, controller);
    if (!group || !mount) return {};
    // A group outside of what is mounted (`/../other` in a namespace) cannot be read: its nearest
    // relative that can is the mount's own.
    fs::path below = fs::path(*group).lexically_relative(mount->group);
    if (below.empty() || *below.begin() == "..") below = ".";
    std::vector<fs::path> folders{mount->place};
    for (const fs::path& step : below) folders.push_back(folders.back() / step);
    return folders;
}

std::vector<std::string> first_words(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return split(line, ' ');
}

}  // namespace pxm::host
