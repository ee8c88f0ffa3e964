// Any bytes as a list of points: they are read, or a reason is given.
#include "host/import/moments/picture.hpp"

#include "tests/fuzz/one_input.hpp"

using namespace pxm::host;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return pxm::fuzz::one_input(
        data, size, [](const std::string& text) { (void)read_points("fuzz.txt", text); });
}
