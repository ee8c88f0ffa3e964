// Any bytes as an EXR: its largest sizes are found, or it is refused.
#include "host/files/exr_header.hpp"

#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/one_input.hpp"

using namespace pxm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return fuzz::one_input(data, size, [](const std::string& text) {
        const host::RegularFile file(fuzz::memory_file(text));
        (void)host::largest_exr_sizes(file);
    });
}
