// Cells as Wavefront OBJ: each cell's vertices, then its faces.
#include <fmt/format.h>

#include <cstdint>
#include <iterator>

#include "host/export/sink.hpp"
#include "host/export/writers.hpp"
#include "host/output/pixel_values.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

void put_vertex(std::string& text, const glm::dvec3& p, CoordinateNumber number) {
    const auto out = std::back_inserter(text);
    if (number == CoordinateNumber::single)
        fmt::format_to(out, "v {} {} {}", static_cast<float>(p.x), static_cast<float>(p.y),
                       static_cast<float>(p.z));
    else
        fmt::format_to(out, "v {} {} {}", p.x, p.y, p.z);
}

/// The format says nothing of colours; readers take them for sRGB.
float shade(double linear) { return srgb_from_linear(static_cast<float>(linear)); }

}  // namespace

void write_obj(const ExportJob& job, CheckedFile& file) {
    Sink sink(file);
    std::string& text = sink.text();
    text += fmt::format("# {}\n", printable_path(job.title));
    std::uint64_t base = 1;
    const ExportSystem* last = nullptr;
    for_each_cell(job.scene, job.watch, [&](const ExportSystem& system, const Cell& cell) {
        if (&system != last) text += fmt::format("o {}\n", system.name);
        last = &system;
        const Mesh& shape = system.sets[static_cast<std::size_t>(cell.set)].shape;
        for (const glm::dvec3& v : shape.vertices) {
            put_vertex(text, cell.place.point(v), job.tally.number);
            if (job.tally.colored)
                fmt::format_to(std::back_inserter(text), " {:.4g} {:.4g} {:.4g}",
                               shade(cell.color.r), shade(cell.color.g), shade(cell.color.b));
            text += '\n';
        }
        const bool mirrored = determinant(cell.place) < 0;
        for (const auto& face : shape.faces) {
            text += 'f';
            for (std::size_t i = 0; i < face.size(); ++i)
                fmt::format_to(std::back_inserter(text), " {}",
                               base + face[mirrored ? face.size() - 1 - i : i]);
            text += '\n';
        }
        base += shape.vertices.size();
        sink.settle();
    });
    sink.flush();
}

}  // namespace pxm::host
