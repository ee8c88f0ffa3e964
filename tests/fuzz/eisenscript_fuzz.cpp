// Any bytes as an EisenScript: they become a scene, or a reason.
#include "host/import/eisenscript/eisen_scene.hpp"

#include "tests/fuzz/one_input.hpp"

using namespace pxm::host;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return pxm::fuzz::one_input(data, size, [](const std::string& text) {
        (void)import_eisenscript({"fuzz.es", text}, 1);
    });
}
