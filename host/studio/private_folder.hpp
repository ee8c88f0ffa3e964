// A folder that only this program looks into, gone with all that is in it when this is.
#pragma once

#include <string>

namespace pxm::host {

class PrivateFolder {
  public:
    /// Throws Error(ErrorKind::file) if the system's place for such folders takes none.
    PrivateFolder();
    ~PrivateFolder();
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    std::string path_;
};

}  // namespace pxm::host
