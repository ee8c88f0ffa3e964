// A file in memory, for readers that want a path.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace pxm::fuzz {

/// Its path, with this text in it. One file: the next call overwrites it.
inline std::string memory_file(const std::string& text) {
    static const int descriptor = memfd_create("fuzz", 0);
    if (descriptor < 0 || ftruncate(descriptor, 0) != 0) std::abort();
    const auto size = static_cast<ssize_t>(text.size());
    if (pwrite(descriptor, text.data(), text.size(), 0) != size) std::abort();
    return "/proc/self/fd/" + std::to_string(descriptor);
}

}  // namespace pxm::fuzz
