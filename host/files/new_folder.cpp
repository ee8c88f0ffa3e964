#include "host/files/new_folder.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <vector>

namespace pxm::host {

namespace fs = std::filesystem;

std::error_code make_folders(const std::string& path) {
    std::error_code error;
    std::vector<fs::path> missing;  // the lowest first
    for (fs::path folder = fs::path(path); !folder.empty() && !fs::exists(folder, error);
         folder = folder.parent_path()) {
        if (folder.has_filename()) missing.push_back(folder);
    }
    for (std::size_t i = missing.size(); i-- > 0;) {
        const fs::path& folder = missing[i];
        std::error_code none;
        fs::create_directory(folder, error);
        if (error && !fs::is_directory(folder, none)) return error;  // or another run has made it
        sync_folder(folder.has_parent_path() ? folder.parent_path().string() : ".");
    }
    error.clear();
    if (!fs::is_directory(path, error) && !error) error.assign(ENOTDIR, std::generic_category());
    return error;
}

void sync_folder(const std::string& folder) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

}  // namespace pxm::host
