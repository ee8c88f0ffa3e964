// Any bytes as a scene: the parser and the checks end, and what is accepted prints and reads back.
// So does its formatted text, which formatting leaves as it is.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "host/error.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/print/format.hpp"
#include "host/scene/print/print.hpp"

using namespace pxm::host;

namespace {

std::string refuse(const std::string& path) {
    throw Error(ErrorKind::file, path + ": no such file");
}

void expect_read_as(const Scene& scene, const std::string& text) {
    Diagnostics diagnostics;
    const Scene copy = parse_text("copy.pxm", text, diagnostics, refuse);
    if (diagnostics.has_errors() || !(copy == scene)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    Diagnostics diagnostics;
    const Scene scene = parse_text("fuzz.pxm", text, diagnostics, refuse);
    const bool accepted = !diagnostics.has_errors();
    check_scene(scene, diagnostics);
    (void)diagnostics.text(scene.files);
    if (!accepted) return 0;
    expect_read_as(scene, print_scene(scene));
    const std::string formatted = format_scene(text);
    expect_read_as(scene, formatted);
    if (format_scene(formatted) != formatted) std::abort();
    return 0;
}
