#include "host/studio/private_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "host/error.hpp"

namespace pxm::host {

PrivateFolder::PrivateFolder() {
    std::error_code error;
    const std::filesystem::path above = std::filesystem::temp_directory_path(error);
    if (error) throw Error(ErrorKind::file, "no folder for temporary files: " + error.message());
    path_ = (above / "pxm-studio-XXXXXX").string();
    if (mkdtemp(path_.data()) == nullptr)
        throw Error(ErrorKind::file, "cannot make a folder in " + above.string());
}

PrivateFolder::~PrivateFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace pxm::host
