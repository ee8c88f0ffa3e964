// Bounding volumes as closed triangle meshes: what stands for a cell in programs that know no
// linear fractals.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/compiled/compiled_scene.hpp"

namespace pxm::host {

struct Mesh {
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // (b - a) x (c - a) points outward
};

/// A mesh around a volume. Boxes and hulls are what they are; balls, cones and cylinders are made
/// of flat faces whose corners lie on them, so that they are a little smaller.
[[nodiscard]] Mesh mesh_of(const CompiledVolume& volume);

/// The volume inside, in cubed lengths; negative if the triangles are turned inward.
[[nodiscard]] double volume_inside(const Mesh& mesh);

/// Whether each edge of a triangle is that of one other, the other way round.
[[nodiscard]] bool is_closed(const Mesh& mesh);

}  // namespace pxm::host
