// The places are CMake's (host/CMakeLists.txt). Those of the build are empty in a package.
#include "host/files/installed_places.hpp"

#include <system_error>

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

/// What a program that lies elsewhere has said; empty: nothing.
struct SetFolders {
    fs::path modules;
    fs::path data;
};
SetFolders& folders_that_were_set() {
    static SetFolders folders;
    return folders;
}

/// `from_program` is relative to the folder of the program that runs.
std::vector<fs::path> places(const fs::path& set, const fs::path& from_program,
                             const fs::path& built, const fs::path& installed) {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    std::vector<fs::path> folders;
    if (!set.empty()) folders.push_back(set);
    if (!error) folders.push_back((program.parent_path() / from_program).lexically_normal());
    if (!built.empty()) folders.push_back(built);
    folders.push_back(installed);
    return folders;
}

}  // namespace

std::vector<fs::path> module_folders() {
    return places(folders_that_were_set().modules, PXM_BIN_TO_MODULES, PXM_BUILT_MODULES,
                  PXM_MODULES);
}

std::vector<fs::path> data_folders() {
    return places(folders_that_were_set().data, PXM_BIN_TO_DATA, PXM_SOURCE_DATA, PXM_DATA);
}

void look_for_modules_in(const fs::path& folder) { folders_that_were_set().modules = folder; }

void look_for_data_in(const fs::path& folder) { folders_that_were_set().data = folder; }

}  // namespace pxm::host
