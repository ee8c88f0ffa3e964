// Cells as a PLY mesh: all vertices, then all faces.
#include <fmt/format.h>

#include <array>
#include <glm/geometric.hpp>
#include <limits>

#include "host/error.hpp"
#include "host/export/sink.hpp"
#include "host/export/writers.hpp"
#include "host/output/pixel_values.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

std::string header(const ExportJob& job) {
    const bool single = job.tally.number == CoordinateNumber::single;
    return fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\n"
        "property {number} x\nproperty {number} y\nproperty {number} z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        printable_path(job.title), job.tally.vertices, job.tally.faces,
        fmt::arg("number", single ? "float" : "double"));
}

}  // namespace

void require_ply(const CellTally& tally) {
    if (tally.vertices <= std::numeric_limits<std::uint32_t>::max()) return;
    throw Error(
        ErrorKind::setting,
        fmt::format("too many vertices: the numbers of a PLY mesh end at {}; fewer --levels, or "
                    "--format gltf, which has instances",
                    std::numeric_limits<std::uint32_t>::max()));
}

void write_ply_mesh(const ExportJob& job, CheckedFile& file) {
    Sink sink(file);
    sink.text() += header(job);
    for_each_cell(job.scene, job.watch, [&](const ExportSystem& system, const Cell& cell) {
        const auto byte = [](double linear) { return srgb_byte(static_cast<float>(linear)); };
        const std::array color{byte(cell.color.r), byte(cell.color.g), byte(cell.color.b)};
        for (const glm::dvec3& v : system.sets[static_cast<std::size_t>(cell.set)].shape.vertices) {
            sink.put_point(cell.place.point(v), job.tally.number);
            sink.put(color);
        }
        sink.settle();
    });
    std::uint32_t base = 0;
    for_each_cell(job.scene, job.watch, [&](const ExportSystem& system, const Cell& cell) {
        const Mesh& shape = system.sets[static_cast<std::size_t>(cell.set)].shape;
        const bool mirrored = determinant(cell.place) < 0;
        for (const auto& face : shape.faces) {
            sink.put(static_cast<std::uint8_t>(face.size()));
            for (std::size_t i = 0; i < face.size(); ++i)
                sink.put(base + face[mirrored ? face.size() - 1 - i : i]);
        }
        base += static_cast<std::uint32_t>(shape.vertices.size());
        sink.settle();
    });
    sink.flush();
}

}  // namespace pxm::host
