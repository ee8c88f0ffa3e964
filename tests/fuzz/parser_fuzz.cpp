// Any bytes as a scene: the parser and the checks end, and what is accepted prints and reads back.
// So does its formatted text, which formatting leaves as it is. A line `----` ends the scene: what
// follows is what it may include, 1.pxm, 2.pxm and so on, with such lines between them.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

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

/// The scene, and the files that it may include.
std::vector<std::string> files_of(std::string text) {
    const std::string between = "\n----\n";
    std::vector<std::string> files;
    for (std::size_t end; (end = text.find(between)) != std::string::npos;) {
        files.push_back(text.substr(0, end + 1));
        text.erase(0, end + between.size());
    }
    files.push_back(text);
    return files;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto files = files_of(std::string(reinterpret_cast<const char*>(data), size));
    const std::string& text = files[0];
    const auto read = [&](const std::string& path) {
        for (std::size_t i = 1; i < files.size(); ++i)
            if (path == std::to_string(i) + ".pxm") return files[i];
        return refuse(path);
    };
    Diagnostics diagnostics;
    const Scene scene = parse_text("fuzz.pxm", text, diagnostics, read);
    const bool accepted = !diagnostics.has_errors();
    check_scene(scene, diagnostics);
    (void)diagnostics.text(scene.files);
    if (!accepted) return 0;
    expect_read_as(scene, print_scene(scene));
    if (files.size() > 1) return 0;  // what is included is formatted for itself
    const std::string formatted = format_scene(text);
    expect_read_as(scene, formatted);
    if (format_scene(formatted) != formatted) std::abort();
    return 0;
}
