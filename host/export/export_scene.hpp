// A scene as it is exported: its objects as systems of maps with shapes at the ends of their words.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/compile/view.hpp"
#include "host/export/cells.hpp"
#include "host/export/export_format.hpp"
#include "host/output/cloud_extent.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// What stands at the ends of words.
struct ShapeChoice {
    VolumeKind kind = VolumeKind::automatic;  // a bounding volume
    std::optional<Mesh> mesh;                 // or this, in the coordinates of the ifs
};

struct ExportRequest {
    std::optional<long> levels;    // in place of what objects say
    std::optional<double> detail;  // a length of the scene
    std::optional<long> voxels;    // along the longest side, where a format has any
    double scale = 1;              // lengths in the file a length of the scene
    bool geometry = false;         // no instances, where a format has them
    ShapeChoice shape;
    double most_cells = 1e9;  // of a file
};

struct ExportScene {
    std::vector<ExportSystem> systems;
    View view;
    std::optional<long> voxels;
    double scale = 1;
    bool geometry = false;
    double most_cells = 1e9;
    const Scene* scene = nullptr;
};

/// Throws Error(ErrorKind::scene) with what is wrong, Error(ErrorKind::setting) if an object says
/// nothing of how deep to go and neither does the request. Warnings go to `diagnostics`. The scene
/// must outlive the result.
[[nodiscard]] ExportScene export_scene(const Scene& scene, const ExportRequest& request,
                                       FileAxes axes, Diagnostics& diagnostics);

}  // namespace pxm::host
