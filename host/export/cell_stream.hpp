// What the writers of cells share: bytes that are collected, cells that are counted on the way, and
// the coordinates of a file.
#pragma once

#include <fmt/format.h>

#include <cstring>
#include <glm/matrix.hpp>
#include <string>
#include <string_view>
#include <type_traits>

#include "host/export/cell_file.hpp"

namespace pxm::host {

/// Bytes on their way into a file.
class ByteStream {
  public:
    explicit ByteStream(CheckedFile& file) : file_(&file) {}

    void put(std::string_view bytes) {
        bytes_.append(bytes);
        if (bytes_.size() >= enough) flush();
    }
    template <class Value>
    void put_value(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        put({reinterpret_cast<const char*>(&value), sizeof value});
    }
    void put_vector(const glm::dvec3& v) {
        const float values[3] = {static_cast<float>(v.x), static_cast<float>(v.y),
                                 static_cast<float>(v.z)};
        put_value(values);
    }
    template <class... Values>
    void print(fmt::format_string<Values...> text, Values&&... values) {
        fmt::format_to(std::back_inserter(bytes_), text, std::forward<Values>(values)...);
        if (bytes_.size() >= enough) flush();
    }
    void flush() {
        file_->append(bytes_.data(), bytes_.size());
        bytes_.clear();
    }

  private:
    static constexpr std::size_t enough = std::size_t{1} << 20U;
    CheckedFile* file_;
    std::string bytes_;
};

/// A signal came.
struct ExportStopped {};

/// Goes through all cells so many times; says how far it is.
class CellPasses {
  public:
    CellPasses(const CellFile& cells, int passes);

    /// Calls each(object, cell, place), with the cell's place in the file's coordinates. Throws
    /// ExportStopped if a signal comes.
    template <class Each>
    void go_through(const Each& each) {
        for (const ExportedObject& object : cells_->objects) {
            CellWalk walk(object, cells_->limit);
            while (const Cell* cell = walk.next()) {
                each(object, *cell, then(cell->place, to_file_));
                if (++done_ % 16'384 == 0) look_up();
            }
        }
    }
    /// From the scene's coordinates to the file's.
    [[nodiscard]] const Affine& to_file() const { return to_file_; }

  private:
    void look_up() const;

    const CellFile* cells_;
    Affine to_file_;
    std::uint64_t done_ = 0;
    double all_ = 1;
};

/// From the scene's coordinates to those of a right-handed file: z is turned over, so that nothing
/// is mirrored.
[[nodiscard]] Affine file_coordinates(const CellFile& cells);

/// The mesh of a cell.
[[nodiscard]] inline const Mesh& mesh_of(const ExportedObject& object, const Cell& cell) {
    return object.meshes[static_cast<std::size_t>(cell.set)];
}
[[nodiscard]] inline bool is_mirrored(const Affine& place) {
    return glm::determinant(place.linear) < 0;
}
/// The corners of a triangle as they stand outward in a place.
[[nodiscard]] inline std::array<std::uint32_t, 3> outward(std::array<std::uint32_t, 3> triangle,
                                                          bool mirrored) {
    if (mirrored) std::swap(triangle[1], triangle[2]);
    return triangle;
}

/// How many vertices and triangles all cells have as triangles of their own.
struct GeometrySize {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
};
[[nodiscard]] GeometrySize geometry_size(const CellFile& cells);

void write_ply(const CellFile& cells, CheckedFile& file);
void write_obj(const CellFile& cells, CheckedFile& file);
void write_stl(const CellFile& cells, CheckedFile& file);
void write_gltf(const CellFile& cells, bool binary, CheckedFile& file);
void write_usda(const CellFile& cells, CheckedFile& file);
void write_pov(const CellFile& cells, CheckedFile& file);

}  // namespace pxm::host
