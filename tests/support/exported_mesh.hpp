// Readers of what `pxm export` writes that know nothing of how it is written: triangles in the
// order of the file, from PLY, OBJ, STL and GLB, and what must hold of them.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace pxm::test {

using Triangle = std::array<glm::dvec3, 3>;
using Triangles = std::vector<Triangle>;

[[nodiscard]] Triangles triangles_of_ply(const std::string& bytes);
[[nodiscard]] Triangles triangles_of_obj(const std::string& text);
[[nodiscard]] Triangles triangles_of_stl(const std::string& bytes);
/// Of a scene of meshes and of instances. `data` is the buffer of a .gltf, else it is a .glb.
[[nodiscard]] Triangles triangles_of_gltf(const std::string& bytes, const std::string& data = "");

/// The volume inside, positive where faces look outward.
[[nodiscard]] double inside_of(const Triangles& triangles);
/// Whether every edge is passed as often one way as the other: the surface has no rim.
[[nodiscard]] bool has_no_rim(const Triangles& triangles);
struct Extent {
    glm::dvec3 low{0.0};
    glm::dvec3 high{0.0};
};
[[nodiscard]] Extent extent_of(const Triangles& triangles);

}  // namespace pxm::test
