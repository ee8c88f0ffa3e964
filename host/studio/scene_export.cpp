#include "host/studio/scene_export.hpp"

#include <filesystem>
#include <vector>

#include "host/error.hpp"
#include "host/export/export_file.hpp"
#include "host/files/safe_file.hpp"
#include "host/output/spared_inputs.hpp"

namespace pxm::host {

namespace {

namespace fs = std::filesystem;

/// The file and what comes beside it.
std::vector<fs::path> places_of(const AskedExport& asked, const ExportFormatName& format,
                                const SceneFolder& folder) {
    std::vector<fs::path> places{folder.place_of(asked.file)};
    if (format.format == ExportFormat::gltf)
        places.push_back(
            folder.place_of(fs::path(asked.file).replace_extension(".bin").generic_string()));
    return places;
}

ExportRequest request_of(const AskedExport& asked, const ExportFormatName& format) {
    ExportRequest request;
    request.most_cells = exported_cells;
    if (format.format == ExportFormat::aifs || format.format == ExportFormat::flame) return request;
    request.levels = asked.levels;
    request.detail = asked.detail;
    return request;
}

}  // namespace

Exported export_asked(const AskedExport& asked, const SceneFolder& folder,
                      const std::atomic<bool>& stop, const std::function<void(double)>& progress) {
    const ExportFormatName& format = choose_export_format("", asked.file);
    const std::vector<fs::path> places = places_of(asked, format, folder);
    try {
        std::vector<std::string> outputs;
        for (const fs::path& place : places) {
            if (!asked.replaces && fs::exists(fs::symlink_status(place)))
                return {ExportEnd::there_already, {}};
            require_writable(place.string());
            outputs.push_back(place.string());
        }
        const Scene scene = scene_of(request_of(asked.scene));
        require_spared(outputs, inputs_of(scene));
        const ExportOutcome outcome =
            export_file(scene, request_of(asked, format), format, outputs.front(),
                        "pxm " PXM_VERSION " export of " + asked.scene.name, progress, stop);
        return {outcome.stopped ? ExportEnd::stopped : ExportEnd::written,
                folder.told(outcome.messages)};
    } catch (const Error& error) {
        if (!error.mistakes().empty()) throw;
        throw Error(error.kind(), folder.told(error.what()));
    }
}

}  // namespace pxm::host
