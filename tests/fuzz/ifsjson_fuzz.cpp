// Any bytes as a file of IFSRenderer: they become a scene, or a reason.
#include "host/import/ifsrenderer/ifsjson.hpp"

#include "tests/fuzz/one_input.hpp"

using namespace pxm::host;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return pxm::fuzz::one_input(data, size, [](const std::string& text) {
        (void)import_ifsjson({"fuzz.ifsjson", text});
    });
}
