// The CPU quota of control groups: /proc/self/cgroup names the process's group in each
// hierarchy, /proc/self/mountinfo where a hierarchy is mounted and from which group on. A limit of
// any group around the process's own holds for it too.
#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>
#include <vector>

#include "host/process/granted_threads.hpp"
#include "host/text/number_text.hpp"

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

enum class Version { one, two };

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

/// The process's group in the hierarchy that limits CPU time; lines are `id:controllers:path`.
std::optional<std::string> group_of(const fs::path& root, Version version) {
    std::ifstream file(root / "proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        if (version == Version::two ? controllers.empty() : holds(controllers, "cpu"))
            return line.substr(second + 1);
    }
    return std::nullopt;
}

struct Mount {
    fs::path group;  // the part of the hierarchy that is seen there
    fs::path place;
};

/// Lines are `id parent device ROOT PLACE options [tags] - TYPE source OPTIONS`.
std::optional<Mount> mount_of(const fs::path& root, Version version) {
    std::ifstream file(root / "proc/self/mountinfo");
    for (std::string line; std::getline(file, line);) {
        const std::vector<std::string> words = split(line, ' ');
        const auto dash = std::ranges::find(words, "-");
        if (words.end() - dash < 4 || dash - words.begin() < 5) continue;
        const bool found = version == Version::two ? dash[1] == "cgroup2"
                                                   : dash[1] == "cgroup" && holds(dash[3], "cpu");
        if (found) return Mount{words[3], root / fs::path(words[4]).relative_path()};
    }
    return std::nullopt;
}

/// The first line's words of a file of one group.
std::vector<std::string> words_of(const fs::path& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return split(line, ' ');
}

std::optional<double> quota_of(const fs::path& folder, Version version) {
    std::vector<std::string> words;  // microseconds of CPU time in a period, and the period
    if (version == Version::two) {
        words = words_of(folder / "cpu.max");
    } else {
        for (const char* name : {"cpu.cfs_quota_us", "cpu.cfs_period_us"})
            for (const std::string& word : words_of(folder / name)) words.push_back(word);
    }
    if (words.size() != 2) return std::nullopt;
    const auto quota = number_of_text<double>(words[0]);  // v2: "max", v1: -1 where there is none
    const auto period = number_of_text<double>(words[1]);
    if (!quota || !period || *quota <= 0 || *period <= 0) return std::nullopt;
    return *quota / *period;
}

std::optional<double> quota_of(const fs::path& root, Version version, std::optional<double> least) {
    const auto group = group_of(root, version);
    const auto mount = mount_of(root, version);
    if (!group || !mount) return least;
    // A group outside of what is mounted (`/../other` in a namespace) cannot be read: its nearest
    // relative that can is the mount's own.
    fs::path below = fs::path(*group).lexically_relative(mount->group);
    if (below.empty() || *below.begin() == "..") below = ".";
    fs::path folder = mount->place;
    const auto look = [&] {
        const auto quota = quota_of(folder, version);
        if (quota) least = std::min(*quota, least.value_or(*quota));
    };
    look();
    for (const fs::path& step : below) {
        folder /= step;
        look();
    }
    return least;
}

}  // namespace

std::optional<double> cpu_quota(const fs::path& root) {
    return quota_of(root, Version::one, quota_of(root, Version::two, std::nullopt));
}

}  // namespace pxm::host
