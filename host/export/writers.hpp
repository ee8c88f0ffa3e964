// One function a format, each in a file of its own. They write cell by cell and may throw
// ExportStopped, and Error(ErrorKind::setting), before anything is written, where a format cannot
// hold what there is.
#pragma once

#include <cstdint>
#include <string>

#include "host/export/export_scene.hpp"
#include "host/export/tally.hpp"
#include "host/files/checked_file.hpp"

namespace pxm::host {

struct ExportJob {
    const ExportScene& scene;
    const CellTally& tally;
    Watch& watch;
    std::string title;  // for a comment: one line
};

/// How many times a writer visits all cells.
inline constexpr int ply_visits = 2;
inline constexpr int gltf_visits = 1;
inline constexpr int usda_visits = 5;

/// Polygons, corners as numbers of 32 bits; sRGB bytes a vertex.
void write_ply_mesh(const ExportJob& job, CheckedFile& file);
void require_ply(const CellTally& tally);

/// Text; colours behind the coordinates where cells differ in colour.
void write_obj(const ExportJob& job, CheckedFile& file);

/// Binary, triangles.
void write_stl(const ExportJob& job, CheckedFile& file);
void require_stl(const CellTally& tally);

/// Instances (EXT_mesh_gpu_instancing) of the sets' shapes, geometry where cells are sheared.
/// `data` is the name of the file beside a .gltf; a .glb has none and holds everything.
[[nodiscard]] std::string gltf_json(const ExportJob& job, const std::string& data);
void write_gltf_data(const ExportJob& job, CheckedFile& file);
void write_glb(const ExportJob& job, CheckedFile& file);
void require_gltf(const ExportScene& scene, const CellTally& tally, bool is_glb);
/// The same of a .glb as far as the number of cells says it.
void require_instances(const CellTally& tally);

/// A PointInstancer a shape, a prim a cell where cells are sheared.
void write_usda(const ExportJob& job, CheckedFile& file);

/// One level set of all cells; OpenVDB's module is loaded. The second says how large voxels are, as
/// a line.
void write_vdb(const ExportJob& job, CheckedFile& file);
[[nodiscard]] std::string told_of_voxels(const ExportScene& scene, const CellTally& tally);
void require_vdb(const ExportScene& scene, const CellTally& tally);

/// Unions inside unions, a level each: as long as the levels are many, however many the cells.
[[nodiscard]] std::string pov_text(const ExportScene& scene, const std::string& title);

/// The systems themselves. Throws Error(ErrorKind::scene) if they are not of the plane.
[[nodiscard]] std::string flame_text(const Scene& scene, std::string& messages);
[[nodiscard]] std::string aifs_text(const Scene& scene, std::string& messages);

}  // namespace pxm::host
