// Any bytes as a picture: what it claims to hold is bounded before a library unpacks it, and it is
// read to its end, or refused.
#include "host/files/image_reader.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/one_input.hpp"

using namespace pxm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr host::ImageLimits small{256, 128L * 128};
    return fuzz::one_input(data, size, [&](const std::string& text) {
        host::ImageReader reader(fuzz::memory_file(text), small);
        (void)host::read_linear_picture(reader);
    });
}
