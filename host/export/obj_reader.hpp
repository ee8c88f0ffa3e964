// Wavefront OBJ, as far as a shape needs it: a user's own mesh in place of bounding volumes.
#pragma once

#include <string>
#include <string_view>

#include "host/export/mesh.hpp"

namespace pxm::host {

inline constexpr std::size_t obj_vertices = 1'000'000;

/// The vertices (v) and faces (f) of a text, faces of more corners cut into triangles; everything
/// else is left out. Throws Error(ErrorKind::scene) with line and column if a number is none, a
/// corner is not there, nothing is a face, or there are more than obj_vertices vertices or faces.
[[nodiscard]] Mesh mesh_of_obj(const std::string& path, std::string_view text);

}  // namespace pxm::host
