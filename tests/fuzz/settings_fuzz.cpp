// Any bytes as what the command line takes beside numbers: frames, and the names of their files.
#include <cstdlib>

#include "host/output/frame_list.hpp"
#include "tests/fuzz/one_input.hpp"

using namespace pxm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::one_input(data, size, [](const std::string& text) {
        constexpr long frames = 1000;
        for (const long frame : host::frames_of(text, frames))
            if (frame < 0 || frame >= frames) std::abort();
    });
    return fuzz::one_input(data, size, [](const std::string& text) {
        if (host::has_frame_number(text)) (void)host::path_of_frame(text, 7);
    });
}
