#include "host/files/folder_names.hpp"

#include <dirent.h>

#include <cerrno>
#include <memory>
#include <string_view>

namespace pxm::host {

std::vector<std::string> names_in(const std::string& folder, std::error_code& error) {
    const auto last_error = [] { return std::error_code(errno, std::generic_category()); };
    const std::unique_ptr<DIR, void (*)(DIR*)> open(opendir(folder.c_str()),
                                                    [](DIR* directory) { closedir(directory); });
    std::vector<std::string> names;
    if (!open) {
        error = last_error();
        return names;
    }
    errno = 0;
    while (const dirent* entry = readdir(open.get())) {
        const std::string_view name = entry->d_name;
        if (name != "." && name != "..") names.emplace_back(name);
        errno = 0;
    }
    if (errno != 0) error = last_error();
    return names;
}

}  // namespace pxm::host
