// Any bytes as a flame: they become a scene, or a reason.
#include "host/import/flame/flame.hpp"

#include "tests/fuzz/one_input.hpp"

using namespace pxm::host;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return pxm::fuzz::one_input(data, size, [](const std::string& text) {
        (void)import_flame({"fuzz.flame", text}, {{}, Variations::affine_part});
    });
}
