// What a glTF file of cells is made of, before it is written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/export/cell_file.hpp"

namespace pxm::host {

/// A mesh of the file with its places, or the triangles of all cells of an object.
struct GltfPart {
    const ExportedObject* object = nullptr;
    int set = -1;  // -1: all, as triangles
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t instances = 0;  // 0: triangles
    /// Of the vertices, as the file's floats have them.
    std::array<float, 3> low{};
    std::array<float, 3> high{};
};

/// The parts, those with no cells left out. Triangles' low and high are not known yet.
[[nodiscard]] std::vector<GltfPart> gltf_parts(const CellFile& cells);

/// Of the numbers that follow the description.
[[nodiscard]] std::uint64_t gltf_buffer_bytes(const std::vector<GltfPart>& parts);

/// No less than the binary file has, with its description.
[[nodiscard]] std::uint64_t gltf_bytes(const CellFile& cells);

/// The description (JSON). `buffer` is what the buffer begins with in a text file, up to its bytes'
/// own text, which goes in the place of `gltf_buffer_mark`; empty in a binary file.
inline constexpr const char* gltf_buffer_mark = "@";
[[nodiscard]] std::string gltf_json(const std::vector<GltfPart>& parts, const CellFile& cells,
                                    const std::string& buffer);

}  // namespace pxm::host
