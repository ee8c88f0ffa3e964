// Any bytes as an AIFS file: they become a scene, or a reason.
#include "host/import/aifs/aifs_scene.hpp"

#include "tests/fuzz/one_input.hpp"

using namespace pxm::host;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return pxm::fuzz::one_input(data, size, [](const std::string& text) {
        (void)import_aifs({"fuzz.aifs", text}, {});
    });
}
