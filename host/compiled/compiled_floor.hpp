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
    std::uint32_t width = 0;   // texels
    std::uint32_t height = 0;  // texels
    std::uint32_t texels = 0;  // word address
};

struct CompiledPointMap {                // a map of a flat attractor: x' = x T + a
    std::array<glm::dvec2, 2> linear{};  // rows
    glm::dvec2 offset{0.0};              // a
    int set = 0;                         // of what may stand inside
};

struct CompiledPointSet {    // what may stand inside a map of a flat attractor
    glm::dvec2 center{0.0};  // of a disk around it
    double radius = 0;       // of the disk
    std::vector<int> maps;   // that may come next: indices into CompiledTexture::maps
};

struct CompiledTexture {                                      // what may lie on a plane
    std::string name;                                         // as the scene calls it
    kernels::TextureKind kind = kernels::TextureKind::image;  // which of the members below count
    glm::dvec3 color{1.0};   // linear: of the attractor, or of light wood; it multiplies an image
    glm::dvec3 color2{1.0};  // linear: of what is between, or of dark wood
    glm::dvec3 mean{1.0};    // from far away
    // image
    std::vector<CompiledImageLevel> levels;  // finest first
    double unit = 1;                         // a texel's unit, squared
    // wood
    double aspect = 1;  // the length of a board, in widths
    // inclusion; the system in coordinates of its own
    std::vector<CompiledPointSet> sets;  // its follow sets
    std::vector<CompiledPointMap> maps;  // its maps
    int start = 0;                       // the set of the outermost maps
    glm::dvec2 corner{0.0};              // of its origin in a repeat
    glm::dvec2 step{1.0};                // repeats a unit
};

/// A texture as it lies on a plane.
struct CompiledLayer {
    int texture = 0;           // an index into CompiledScene::textures
    glm::dvec3 origin{0.0};    // a corner of repeat (first_u, first_v), near the eye
    glm::dvec3 across{0.0};    // repeats a scene unit
    glm::dvec3 along{0.0};     // the same of v
    std::int32_t first_u = 0;  // the number of that repeat in u
    std::int32_t first_v = 0;  // and in v
};

struct CompiledPlane {                  // a floor or wall: the points x with normal . x = offset
    std::string name;                   // as the scene calls it
    glm::dvec3 normal{0.0, 1.0, 0.0};   // a unit vector
    double offset = 0;                  // from the eye, in scene units
    glm::dvec3 color{0.0};              // linear
    double diffuse = 0;                 // share of diffuse reflection, 0 to 1
    double reflect = 0;                 // share of a mirror's image, 0 to 1
    std::vector<CompiledLayer> layers;  // of textures; their colours multiply
};

}  // namespace pxm::host
