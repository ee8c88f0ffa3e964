// Text to scene: reads a .pxm file and what it includes (docs/scene-language.md).
#pragma once

#include <functional>
#include <string>

#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Reads a file's whole text. Throws Error(ExitCode::file) when it cannot be read.
using FileReader = std::function<std::string(const std::string& path)>;

/// The real file system; a directory, a missing file or one over 64 MB is an Error(ExitCode::file).
[[nodiscard]] std::string read_file(const std::string& path);

/// The number that a `let` stands for, given the one it is written with.
using LetNumber = std::function<double(const std::string& name, double written)>;

/// Parses the scene file at `path`. Syntax errors go to `diagnostics` (the parser goes on after
/// each); scene.files is filled in either case. An include that cannot be found is a scene error at
/// its place. `let_number` may change the numbers of `let`s.
[[nodiscard]] Scene parse_scene(const std::string& path, Diagnostics& diagnostics,
                                const FileReader& reader = read_file,
                                const LetNumber& let_number = nullptr);

/// Parses text that is in memory; `name` stands in messages. Includes are read through `reader`.
[[nodiscard]] Scene parse_text(const std::string& name, const std::string& text,
                               Diagnostics& diagnostics, const FileReader& reader = read_file,
                               const LetNumber& let_number = nullptr);

}  // namespace pxm::host
