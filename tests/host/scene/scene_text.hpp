// Scenes in memory for tests: files by name, and the whole text of what the parser says.
#pragma once

#include <map>
#include <string>

#include "host/error.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::test {

using Files = std::map<std::string, std::string>;

inline host::FileReader reader_of(const Files& files) {
    return [files](const std::string& path) {
        const auto found = files.find(path);
        if (found == files.end()) throw host::Error(host::ErrorKind::file, path + ": no such file");
        return found->second;
    };
}

/// The parser's messages for a scene called s.pxm; empty if it is accepted.
inline std::string parse_messages(const std::string& text, const Files& files = {}) {
    host::Diagnostics diagnostics;
    const host::Scene scene = host::parse_text("s.pxm", text, diagnostics, reader_of(files));
    return diagnostics.text(scene.files);
}

/// The scene of a text without mistakes; throws host::Error with the messages otherwise.
inline host::Scene parsed(const std::string& text, const Files& files = {}) {
    host::Diagnostics diagnostics;
    host::Scene scene = host::parse_text("s.pxm", text, diagnostics, reader_of(files));
    diagnostics.throw_if_errors(scene.files);
    return scene;
}

/// The checker's messages for a text that parses.
inline std::string check_messages(const std::string& text) {
    const host::Scene scene = parsed(text);
    host::Diagnostics diagnostics;
    host::check_scene(scene, diagnostics);
    return diagnostics.text(scene.files);
}

}  // namespace pxm::test
