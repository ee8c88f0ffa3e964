// Where OpenImageIO's writers put their bytes. Most of them ignore the result of a write: on a full
// disk the picture would lack its end. Those that take a place to write to get one that
// remembers the first write that failed; what the others wrote is read back and compared.
#pragma once

#include <OpenImageIO/filesystem.h>

#include <cstdint>
#include <string>

#include "host/files/checked_file.hpp"
#include "host/text/digest.hpp"

namespace pxm::host {

/// A place to write to, over a file that checks every write. Used by one thread.
class ImageSink : public OIIO::Filesystem::IOProxy {
  public:
    /// `file` must outlive it.
    ImageSink(CheckedFile& file, const std::string& name)
        : IOProxy(name, IOProxy::Write), file_(file) {}

    [[nodiscard]] const char* proxytype() const override { return "pxm"; }
    std::size_t read(void* data, std::size_t bytes) override;
    std::size_t write(const void* data, std::size_t bytes) override;
    std::size_t pread(void* data, std::size_t bytes, std::int64_t place) override;
    std::size_t pwrite(const void* data, std::size_t bytes, std::int64_t place) override;
    [[nodiscard]] std::size_t size() const override;

  private:
    CheckedFile& file_;
};

/// Why the picture in that file, of three channels of 8 bits, is not the one whose bytes were
/// written row by row; empty if it is.
[[nodiscard]] std::string why_not_as_written(const std::string& path, int width, int height,
                                             const Digest& rows);

}  // namespace pxm::host
