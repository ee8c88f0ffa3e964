// Text to scene: reads a .pxm file and what it includes (docs/scene-language.md).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/files/regular_file.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Reads a file's whole text. Throws Error(ErrorKind::file) when it cannot be read.
using FileReader = std::function<std::string(const std::string& path)>;

/// The path of an included file, given the one that starts at the including file and the one that
/// was written.
using IncludeFinder =
    std::function<std::string(const std::string& path, const std::string& written)>;

/// The number that a `let` stands for, given the one it is written with.
using LetNumber = std::function<double(const std::string& name, double written)>;

/// Parses the scene file at `path`. Syntax errors go to `diagnostics` (the parser goes on after
/// each); scene.files is filled in either case. An include that cannot be found is a scene error at
/// its place, and so is one, or the picture of a texture, that lies neither below the scene's
/// folder nor below one of `allowed`. What is not beside the including file is looked for in the
/// scene folders (scene_path.hpp), and one where it is found is allowed from there on. `let_number`
/// may change the numbers of `let`s. A `text` stands for what the file holds, which is not read
/// then. `frame` is that of an animation, and need not be whole.
[[nodiscard]] Scene parse_scene(const std::string& path, Diagnostics& diagnostics,
                                const std::vector<std::string>& allowed = {},
                                const LetNumber& let_number = nullptr,
                                const std::optional<std::string>& text = {}, double frame = 0);

/// Parses text that is in memory; `name` stands in messages. Includes are read through `reader`,
/// and may lie anywhere.
[[nodiscard]] Scene parse_text(
    const std::string& name, const std::string& text, Diagnostics& diagnostics,
    const FileReader& reader = [](const std::string& path) { return read_file(path); },
    const LetNumber& let_number = nullptr, double frame = 0,
    const IncludeFinder& find_included = nullptr);

/// The time of a frame: 0 at the first, 1 at the last; of a single one 0.
[[nodiscard]] double time_of(const AnimationBlock& animation, double frame);

}  // namespace pxm::host
