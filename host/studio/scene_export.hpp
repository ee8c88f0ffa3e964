// What `pxm export` writes, from the page: a scene's cells or systems as a file below the folder.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "host/studio/asks.hpp"
#include "host/studio/scene_folder.hpp"

namespace pxm::host {

inline constexpr double exported_cells = 4e6;  // of one file

struct AskedExport {
    AskedScene scene;
    std::string file;              // its extension says the format
    std::optional<long> levels;    // of cells
    std::optional<double> detail;  // a length of the scene
    bool replaces = false;         // a file that is there already
};

enum class ExportEnd { written, there_already, stopped };

struct Exported {
    ExportEnd end = ExportEnd::written;
    std::string messages;
};

/// Writes the file whole or not at all. `progress` hears which share is done. Throws Error as
/// export_file and SceneFolder::open do.
[[nodiscard]] Exported export_asked(const AskedExport& asked, const SceneFolder& folder,
                                    const std::atomic<bool>& stop,
                                    const std::function<void(double)>& progress);

}  // namespace pxm::host
