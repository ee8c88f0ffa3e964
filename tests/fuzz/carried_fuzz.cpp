// Any bytes as a picture that carries its scene, PNG or EXR, and as the text that it carries: it is
// refused, or it is written and read back the same, and its scene is parsed.
#include "host/files/carried_text.hpp"

#include <cstdlib>
#include <exception>

#include "host/scene/carried/carried_json.hpp"
#include "host/scene/carried/carried_scene.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/one_input.hpp"

using namespace pxm;

namespace {

void take_text(const std::string& text) {
    host::CarriedScene carried;
    try {
        carried = host::carried_of_json(text);
    } catch (const std::exception&) {  // the caller says whose text it is
        return;
    }
    const std::string written = host::carried_json(carried);
    host::CarriedScene copy = host::carried_of_json(written);
    if (host::carried_json(copy) != written) std::abort();
    if (carried.files.empty()) return;
    host::Diagnostics diagnostics;
    const host::Scene scene = host::parse_carried(carried, "fuzz.png", diagnostics);
    (void)diagnostics.text(scene.files);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 0 && data[0] == '{') return fuzz::one_input(data, size, take_text);
    return fuzz::one_input(data, size, [](const std::string& picture) {
        const host::RegularFile file(fuzz::memory_file(picture));
        if (const auto text = host::carried_text(file)) take_text(*text);
    });
}
