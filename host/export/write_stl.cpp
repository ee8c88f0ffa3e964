// Cells as binary STL: triangles with their normals.
#include <fmt/format.h>

#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "host/error.hpp"
#include "host/export/sink.hpp"
#include "host/export/writers.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t header_bytes = 80;

void put_triangle(Sink& sink, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double length = glm::length(across);
    sink.put_floats(length > 0 ? across / length : glm::dvec3{0.0});
    sink.put_floats(a);
    sink.put_floats(b);
    sink.put_floats(c);
    sink.put(std::uint16_t{0});
}

}  // namespace

void require_stl(const CellTally& tally) {
    if (tally.triangles > std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorKind::setting,
                    fmt::format("too many triangles: STL counts to {}; fewer --levels",
                                std::numeric_limits<std::uint32_t>::max()));
    if (tally.number == CoordinateNumber::double_)
        throw Error(ErrorKind::setting,
                    "the cells are too small, or too far from the origin, for the floats of STL");
}

void write_stl(const ExportJob& job, CheckedFile& file) {
    Sink sink(file);
    // Not beginning with `solid`, by which readers know the text form.
    std::string header = fmt::format("binary STL, z up, 1 = {:g} of the scene; {}",
                                     1 / job.scene.scale, printable_path(job.title));
    header.resize(header_bytes, ' ');
    sink.text() += header;
    sink.put(static_cast<std::uint32_t>(job.tally.triangles));
    std::map<std::pair<const ExportSystem*, int>, std::vector<std::array<std::uint32_t, 3>>> known;
    for_each_cell(job.scene, job.watch, [&](const ExportSystem& system, const Cell& cell) {
        const Mesh& shape = system.sets[static_cast<std::size_t>(cell.set)].shape;
        auto& triangles = known[{&system, cell.set}];
        if (triangles.empty()) triangles = triangles_of(shape);
        const bool mirrored = determinant(cell.place) < 0;
        const auto at = [&](std::uint32_t i) { return cell.place.point(shape.vertices[i]); };
        for (const auto& [a, b, c] : triangles)
            put_triangle(sink, at(a), at(mirrored ? c : b), at(mirrored ? b : c));
        sink.settle();
    });
    sink.flush();
}

}  // namespace pxm::host
