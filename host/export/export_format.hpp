// The files that a scene can be exported to.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace pxm::host {

enum class ExportFormat { gltf, glb, usda, obj, ply, stl, vdb, pov, aifs, flame };

/// Axes of a file. A scene is left-handed: x to the right, y up, z away from the viewer.
enum class FileAxes {
    of_scene,     // as they are
    z_to_viewer,  // right-handed, y up: z turned over
    z_up          // right-handed, z up: y and z change places
};

struct ExportFormatName {
    std::string_view text;
    ExportFormat format;
    FileAxes axes;
};

inline constexpr std::array<ExportFormatName, 10> export_formats{
    {{"gltf", ExportFormat::gltf, FileAxes::z_to_viewer},
     {"glb", ExportFormat::glb, FileAxes::z_to_viewer},
     {"usda", ExportFormat::usda, FileAxes::z_to_viewer},
     {"obj", ExportFormat::obj, FileAxes::z_to_viewer},
     {"ply", ExportFormat::ply, FileAxes::of_scene},
     {"stl", ExportFormat::stl, FileAxes::z_up},
     {"vdb", ExportFormat::vdb, FileAxes::z_to_viewer},
     {"pov", ExportFormat::pov, FileAxes::of_scene},
     {"aifs", ExportFormat::aifs, FileAxes::of_scene},
     {"flame", ExportFormat::flame, FileAxes::of_scene}}};

/// The names with bars between them.
[[nodiscard]] std::string export_format_words();

/// The format of that name, or of the path's extension if no name is given. Throws
/// Error(ErrorKind::setting).
[[nodiscard]] const ExportFormatName& choose_export_format(const std::string& name,
                                                           const std::string& path);

}  // namespace pxm::host
