// The CPU quota of control groups.
#include <algorithm>

#include "host/process/control_group.hpp"
#include "host/process/granted_threads.hpp"
#include "host/text/number_text.hpp"

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

std::optional<double> quota_of(const fs::path& folder, GroupVersion version) {
    std::vector<std::string> words;  // microseconds of CPU time in a period, and the period
    if (version == GroupVersion::two) {
        words = first_words(folder / "cpu.max");
    } else {
        for (const char* name : {"cpu.cfs_quota_us", "cpu.cfs_period_us"})
            for (const std::string& word : first_words(folder / name)) words.push_back(word);
    }
    if (words.size() != 2) return std::nullopt;
    const auto quota = number_of_text<double>(words[0]);  // v2: "max", v1: -1 where there is none
    const auto period = number_of_text<double>(words[1]);
    if (!quota || !period || *quota <= 0 || *period <= 0) return std::nullopt;
    return *quota / *period;
}

std::optional<double> quota_of(const fs::path& root, GroupVersion version,
                               std::optional<double> least) {
    for (const fs::path& folder : group_folders(root, version, "cpu")) {
        const auto quota = quota_of(folder, version);
        if (quota) least = std::min(*quota, least.value_or(*quota));
    }
    return least;
}

}  // namespace

std::optional<double> cpu_quota(const fs::path& root) {
    return quota_of(root, GroupVersion::one, quota_of(root, GroupVersion::two, std::nullopt));
}

}  // namespace pxm::host
