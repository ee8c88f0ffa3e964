// Any bytes as a scene: the parser and the checks end, and what is accepted prints and reads back.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "host/error.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/print/print.hpp"

using namespace pxm::host;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const FileReader refuse = [](const std::string& path) -> std::string {
        throw Error(ErrorKind::file, path + ": no such file");
    };
    const std::string text(reinterpret_cast<const char*>(data), size);
    Diagnostics diagnostics;
    const Scene scene = parse_text("fuzz.pxm", text, diagnostics, refuse);
    const bool accepted = !diagnostics.has_errors();
    check_scene(scene, diagnostics);
    (void)diagnostics.text(scene.files);
    if (!accepted) return 0;
    Diagnostics again;
    const Scene copy = parse_text("copy.pxm", print_scene(scene), again, refuse);
    if (again.has_errors() || !(copy == scene)) std::abort();
    return 0;
}
