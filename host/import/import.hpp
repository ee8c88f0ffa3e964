// Other people's fractals as scenes: FRACTINT's .ifs and .l files, images and lists of points
// (docs/import.md).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/scene/scene.hpp"

namespace pxm::host {

struct ImportRequest {
    std::string path;                  // by extension (docs/import.md); else an image
    std::optional<std::string> entry;  // of a file that holds several; absent: its only one
    bool affine_part = false;          // of a flame: leave out what is not linear
    int maps = 4;                      // of an image or of points; and the search's seed and time
    std::uint64_t seed = 1;
    double seconds = 20;
    std::function<bool()> stop = {};
};

struct Imported {
    std::string name;  // of the ifs, or of the first object of a scene without one
    Scene scene;
    std::string text;      // the scene's, with a heading
    std::string messages;  // for the user, empty if there are none
};

/// Throws Error: no entry of that name, or several and none asked for (2); not a linear fractal, or
/// mistakes in the entry (3); the file cannot be read (4).
[[nodiscard]] Imported import_file(const ImportRequest& request);

/// The same for text in memory: an .ifs file's, or an .l file's.
enum class FractintFormat { ifs, l };
[[nodiscard]] Imported import_fractint(const SourceFile& source, FractintFormat format,
                                       const std::optional<std::string>& entry);

/// The names of the entries of a file that can be asked for; none of a file that holds one thing.
/// Throws Error as import_file.
[[nodiscard]] std::vector<std::string> entries_of(const std::string& path);

}  // namespace pxm::host
