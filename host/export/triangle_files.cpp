// PLY, OBJ and STL: each cell as triangles of its own.
#include <bit>
#include <glm/geometric.hpp>

#include "host/export/cell_stream.hpp"
#include "host/output/pixel_values.hpp"

namespace pxm::host {

namespace {

static_assert(std::endian::native == std::endian::little, "the files are little endian");

std::array<unsigned char, 3> color_bytes(const glm::dvec3& linear) {
    return {srgb_byte(static_cast<float>(linear.r)), srgb_byte(static_cast<float>(linear.g)),
            srgb_byte(static_cast<float>(linear.b))};
}

}  // namespace

void write_ply(const CellFile& cells, CheckedFile& file) {
    ByteStream out(file);
    const GeometrySize size = geometry_size(cells);
    out.print(
        "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        cells.title, size.vertices, size.triangles);
    CellPasses passes(cells, 2);
    passes.go_through([&](const ExportedObject& object, const Cell& cell, const Affine& place) {
        const auto color = color_bytes(cell.color);
        for (const glm::dvec3& vertex : mesh_of(object, cell).vertices) {
            out.put_vector(place.point(vertex));
            out.put_value(color);
        }
    });
    std::uint32_t first = 0;
    passes.go_through([&](const ExportedObject& object, const Cell& cell, const Affine& place) {
        const Mesh& mesh = mesh_of(object, cell);
        const bool mirrored = is_mirrored(place);
        for (const auto& triangle : mesh.triangles) {
            auto corners = outward(triangle, mirrored);
            for (std::uint32_t& corner : corners) corner += first;
            out.put_value(static_cast<unsigned char>(3));
            out.put_value(corners);
        }
        first += static_cast<std::uint32_t>(mesh.vertices.size());
    });
    out.flush();
}

void write_obj(const CellFile& cells, CheckedFile& file) {
    ByteStream out(file);
    out.print("# {}\n", cells.title);
    std::uint64_t first = 1;
    const ExportedObject* named = nullptr;
    CellPasses(cells, 1).go_through(
        [&](const ExportedObject& object, const Cell& cell, const Affine& place) {
            if (named != &object) out.print("o {}\n", object.name);
            named = &object;
            const Mesh& mesh = mesh_of(object, cell);
            for (const glm::dvec3& vertex : mesh.vertices) {
                const glm::dvec3 at = place.point(vertex);
                out.print("v {} {} {}\n", static_cast<float>(at.x), static_cast<float>(at.y),
                          static_cast<float>(at.z));
            }
            const bool mirrored = is_mirrored(place);
            for (const auto& triangle : mesh.triangles) {
                const auto [a, b, c] = outward(triangle, mirrored);
                out.print("f {} {} {}\n", first + a, first + b, first + c);
            }
            first += mesh.vertices.size();
        });
    out.flush();
}

void write_stl(const CellFile& cells, CheckedFile& file) {
    ByteStream out(file);
    std::string head = cells.title.substr(0, 79);
    head.resize(80, ' ');  // it may not begin with "solid", which is how texts do
    out.put(head);
    out.put_value(static_cast<std::uint32_t>(geometry_size(cells).triangles));
    CellPasses(cells, 1).go_through([&](const ExportedObject& object, const Cell& cell,
                                        const Affine& place) {
        const Mesh& mesh = mesh_of(object, cell);
        const bool mirrored = is_mirrored(place);
        for (const auto& triangle : mesh.triangles) {
            std::array<glm::dvec3, 3> corners;
            const auto turned = outward(triangle, mirrored);
            for (std::size_t i = 0; i < 3; ++i) corners[i] = place.point(mesh.vertices[turned[i]]);
            const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            const double length = glm::length(across);
            out.put_vector(length > 0 ? across / length : glm::dvec3{0.0});
            for (const glm::dvec3& corner : corners) out.put_vector(corner);
            out.put_value(std::uint16_t{0});
        }
    });
    out.flush();
}

}  // namespace pxm::host
