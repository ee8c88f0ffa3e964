// Any bytes as an expression, the value of a `let` and of an animation's frame: a finite number, or
// a reason.
#include <cmath>
#include <cstdlib>
#include <glm/vec3.hpp>

#include "host/scene/parse/parser.hpp"
#include "tests/fuzz/one_input.hpp"

using namespace pxm::host;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return pxm::fuzz::one_input(data, size, [](const std::string& text) {
        Diagnostics diagnostics;
        const Scene scene = parse_text(
            "fuzz.pxm",
            "animation { frames: 3 }\nlet x = 2 let y = " + text + "\ncamera { up: y, 1, 2 }\n",
            diagnostics, nullptr, nullptr, 1);
        (void)diagnostics.text(scene.files);
        if (diagnostics.has_errors() || !scene.camera) return;
        if (scene.camera->up && !std::isfinite(scene.camera->up->x)) std::abort();
    });
}
