// Any bytes as the heading of a part file: it is refused, or it is written and read back the same.
#include <cstdlib>
#include <exception>

#include "host/parts/heading_json.hpp"
#include "tests/fuzz/one_input.hpp"

using namespace pxm::host;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return pxm::fuzz::one_input(data, size, [](const std::string& text) {
        PartHeading heading;
        try {
            heading = heading_of_json(text);
        } catch (const std::exception&) {  // the caller says whose heading it is
            return;
        }
        const std::string written = heading_json(heading);
        if (heading_json(heading_of_json(written)) != written) std::abort();
    });
}
