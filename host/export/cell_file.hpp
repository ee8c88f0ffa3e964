// Files with the cells of objects, for programs that know no linear fractals. Each writer goes
// through the cells as often as its format needs, in the memory of one.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/export/cells.hpp"
#include "host/files/checked_file.hpp"

namespace pxm::host {

enum class CellFormat { ply, obj, stl, glb, gltf, usda, pov };

/// What is written, and how.
struct CellFile {
    std::vector<ExportedObject> objects;  // counted
    CellLimit limit;
    double scale = 1;        // lengths of the file for one of the scene
    bool geometry = false;   // no instances, also where the format has them
    glm::dvec3 offset{0.0};  // of the scene, that is the file's origin: floats keep the digits
    std::string title;       // one printable line
    /// Share of the work, from 0 to 1.
    std::function<void(double)> progress;
};

/// Why the format cannot hold these cells; empty if it can. To be asked before anything is written.
[[nodiscard]] std::string why_not(const CellFile& cells, CellFormat format);

/// Whether cells are instances of a shape there, and not triangles of their own.
[[nodiscard]] bool has_instances(const CellFile& cells, CellFormat format);

/// Writes all of it. False if a signal came. Throws Error(ErrorKind::file).
[[nodiscard]] bool write_cells(const CellFile& cells, CellFormat format, CheckedFile& file);

}  // namespace pxm::host
