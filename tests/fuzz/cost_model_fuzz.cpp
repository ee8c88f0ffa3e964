// Any bytes as a cost model: it is read, or the entry that is wrong is named.
#include "host/output/cost_model_json.hpp"

#include "tests/fuzz/one_input.hpp"

using namespace pxm::host;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return pxm::fuzz::one_input(
        data, size, [](const std::string& text) { (void)parse_cost_model(text, "fuzz.json"); });
}
