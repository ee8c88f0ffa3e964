// Closed surfaces of flat faces: what stands at the end of a word of maps when a scene is exported.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/math/affine.hpp"

namespace pxm::host {

/// Faces are flat polygons with their corners in an order such that the volume is positive: counted
/// in right-handed axes, counter-clockwise as seen from outside.
struct Mesh {
    std::vector<glm::dvec3> vertices;
    std::vector<std::vector<std::uint32_t>> faces;
};

/// The faces as triangles, fans about their first corners.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh);

/// The volume inside; negative if the faces look inward.
[[nodiscard]] double volume_of(const Mesh& mesh);

/// Whether every edge has a face on either side, and none has more.
[[nodiscard]] bool is_closed(const Mesh& mesh);

/// Makes the faces look to the other side.
void turn_over(Mesh& mesh);

/// The image. A map that mirrors turns the faces over, so that they look outward again.
[[nodiscard]] Mesh image_of(const Mesh& mesh, const Affine& map);

/// The surface of a bounding volume: of a box or a hull exactly, of a ball 80 triangles with
/// their corners on it, of a cone or a cylinder a prism of 32 sides.
[[nodiscard]] Mesh mesh_of(const CompiledVolume& volume);

/// The mesh of an OBJ or a PLY file (text, or binary with the low byte first). Throws
/// Error(ErrorKind::scene) with the line or the place where it is wrong, Error(ErrorKind::file) if
/// it cannot be read. A mesh that is closed is turned outward.
[[nodiscard]] Mesh read_mesh(const std::string& path);

}  // namespace pxm::host
