// From the text or the file of a scene to its inspection.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "host/inspect/inspection.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::test {

inline host::Inspection inspect_parsed(const host::Scene& scene, const std::string& name,
                                       host::Diagnostics& diagnostics) {
    if (!diagnostics.has_errors()) host::check_scene(scene, diagnostics);
    host::Inspection found;
    if (!diagnostics.has_errors()) found = host::inspect(scene, name, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.text(scene.files);
    return found;
}

inline host::Inspection inspect_text_of(const std::string& name, const std::string& text) {
    host::Diagnostics diagnostics;
    const host::Scene scene = host::parse_text(name, text, diagnostics);
    return inspect_parsed(scene, name, diagnostics);
}

inline host::Inspection inspect_file(const std::string& path) {
    host::Diagnostics diagnostics;
    const host::Scene scene = host::parse_scene(path, diagnostics);
    return inspect_parsed(scene, path, diagnostics);
}

}  // namespace pxm::test
