#include "host/export/cell_file.hpp"

#include <algorithm>
#include <limits>

#include "host/export/cell_stream.hpp"
#include "host/export/gltf_size.hpp"
#include "host/process/interrupt.hpp"

namespace pxm::host {

namespace {

constexpr std::uint64_t most_32 = std::numeric_limits<std::uint32_t>::max();

bool any_sheared(const CellFile& cells) {
    return std::ranges::any_of(cells.objects, &ExportedObject::sheared);
}

/// Whether cells are moved and scaled along the axes alone. A USD instancer turns by 16-bit floats,
/// which is no exact picture.
bool only_scaled(const CellFile& cells) {
    const auto is_diagonal = [](const Affine& map) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                if (i != j && map.linear[i][j] != 0) return false;
        }
        return true;
    };
    return std::ranges::all_of(cells.objects, [&](const ExportedObject& object) {
        return is_diagonal(object.instance) && std::ranges::all_of(object.rifs.maps, is_diagonal);
    });
}

std::string why_not_pov(const CellFile& cells) {
    if (cells.limit.length) {
        return "POV-Ray's file has unions in unions, a level each: say --levels instead of "
               "--detail";
    }
    return "";
}

std::string why_not_stl(const CellFile& cells) {
    const std::uint64_t triangles = geometry_size(cells).triangles;
    if (triangles <= most_32) return "";
    return fmt::format("an STL file holds at most {} triangles, and these are {}", most_32,
                       triangles);
}

}  // namespace

bool has_instances(const CellFile& cells, CellFormat format) {
    if (cells.geometry) return false;
    switch (format) {
        case CellFormat::glb:
        case CellFormat::gltf:
            return !any_sheared(cells);
        case CellFormat::usda:
            return only_scaled(cells);
        case CellFormat::pov:
            return true;
        case CellFormat::ply:
        case CellFormat::obj:
        case CellFormat::stl:
            return false;
    }
    return false;
}

std::string why_not(const CellFile& cells, CellFormat format) {
    if (format == CellFormat::pov) return why_not_pov(cells);
    if (format == CellFormat::stl) return why_not_stl(cells);
    const bool is_gltf = format == CellFormat::glb || format == CellFormat::gltf;
    if (!has_instances(cells, format) && format != CellFormat::obj &&
        geometry_size(cells).vertices > most_32) {
        return fmt::format("the format holds at most {} vertices, and these are {}", most_32,
                           geometry_size(cells).vertices);
    }
    if (is_gltf && gltf_bytes(cells) > most_32) {
        return fmt::format("a glTF file holds at most {} bytes, and these are {}", most_32,
                           gltf_bytes(cells));
    }
    return "";
}

bool write_cells(const CellFile& cells, CellFormat format, CheckedFile& file) {
    try {
        switch (format) {
            case CellFormat::ply:
                write_ply(cells, file);
                break;
            case CellFormat::obj:
                write_obj(cells, file);
                break;
            case CellFormat::stl:
                write_stl(cells, file);
                break;
            case CellFormat::glb:
            case CellFormat::gltf:
                write_gltf(cells, format == CellFormat::glb, file);
                break;
            case CellFormat::usda:
                write_usda(cells, file);
                break;
            case CellFormat::pov:
                write_pov(cells, file);
                break;
        }
    } catch (const ExportStopped&) {
        return false;
    }
    return true;
}

CellPasses::CellPasses(const CellFile& cells, int passes)
    : cells_(&cells), to_file_(file_coordinates(cells)) {
    double count = 0;
    for (const ExportedObject& object : cells.objects) count += static_cast<double>(object.cells());
    all_ = std::max(1.0, count * passes);
}

void CellPasses::look_up() const {
    if (stop_requested()) throw ExportStopped{};
    if (cells_->progress) cells_->progress(static_cast<double>(done_) / all_);
}

Affine file_coordinates(const CellFile& cells) {
    Affine turned;
    turned.linear[0].x = turned.linear[1].y = cells.scale;
    turned.linear[2].z = -cells.scale;
    turned.translation = turned.linear * -cells.offset;
    return turned;
}

GeometrySize geometry_size(const CellFile& cells) {
    GeometrySize size;
    for (const ExportedObject& object : cells.objects) {
        for (std::size_t set = 0; set < object.counts.size(); ++set) {
            size.vertices += object.counts[set] * object.meshes[set].vertices.size();
            size.triangles += object.counts[set] * object.meshes[set].triangles.size();
        }
    }
    return size;
}

}  // namespace pxm::host
