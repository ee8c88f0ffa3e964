// Planes and textures ready for the nodes, in scene units and still in double.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "dsp_kernels/floor_block.hpp"

namespace pxm::host {

/// An image at one size; its texels lie in texture memory, by rows from the top.
struct CompiledImageLevel {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t texels = 0;  // word address
};

struct CompiledPointMap {
    std::array<glm::dvec2, 2> linear{};  // rows
    glm::dvec2 offset{0.0};
    int set = 0;  // of what may stand inside
};

struct CompiledPointSet {
    glm::dvec2 center{0.0};
    double radius = 0;
    std::vector<int> maps;
};

struct CompiledTexture {
    std::string name;
    kernels::TextureKind kind = kernels::TextureKind::image;
    glm::dvec3 color{1.0};
    glm::dvec3 color2{1.0};
    glm::dvec3 mean{1.0};  // from far away
    // image
    std::vector<CompiledImageLevel> levels;  // finest first
    double unit = 1;
    // wood
    double aspect = 1;
    // inclusion; the system in coordinates of its own
    std::vector<CompiledPointSet> sets;
    std::vector<CompiledPointMap> maps;
    int start = 0;
    glm::dvec2 corner{0.0};  // of its origin in a repeat
    glm::dvec2 step{1.0};    // repeats a unit
};

/// A texture as it lies on a plane.
struct CompiledLayer {
    int texture = 0;
    glm::dvec3 origin{0.0};
    glm::dvec3 across{0.0};  // repeats a scene unit
    glm::dvec3 along{0.0};
    std::int32_t first_u = 0;
    std::int32_t first_v = 0;
};

struct CompiledPlane {
    std::string name;
    glm::dvec3 normal{0.0, 1.0, 0.0};
    double offset = 0;
    glm::dvec3 color{0.0};
    double diffuse = 0;
    double reflect = 0;
    std::vector<CompiledLayer> layers;
};

}  // namespace pxm::host
