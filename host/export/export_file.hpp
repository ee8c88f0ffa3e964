// A scene to a file of another program.
#pragma once

#include <atomic>
#include <string>

#include "host/export/export_format.hpp"
#include "host/export/export_scene.hpp"
#include "host/export/tally.hpp"
#include "host/scene/diagnostics.hpp"

namespace pxm::host {

/// The file beside a .gltf that holds its numbers; empty for other formats.
[[nodiscard]] std::string data_path(const ExportFormatName& format, const std::string& path);

struct ExportOutcome {
    std::string messages;  // what was left out, and what the file holds: lines
    bool stopped = false;  // as was asked for; nothing was written
};

/// Throws Error: setting where the format cannot hold what there is, scene where the scene is
/// wrong, file where it cannot be written. Then what was at `path` before is there still.
[[nodiscard]] ExportOutcome export_file(const Scene& scene, const ExportRequest& request,
                                        const ExportFormatName& format, const std::string& path,
                                        const std::string& title, const HearShare& progress,
                                        const std::atomic<bool>& stop);

}  // namespace pxm::host
