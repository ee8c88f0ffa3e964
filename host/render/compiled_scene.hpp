// A scene ready for the nodes, still in double: maps with their inverses, volumes, graph, camera
// and lights, in scene units (the eye at the origin, scaled by a power of two). host/render/compile
// makes it, host/render/scene_block rounds it to node words.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "dsp_kernels/scene_block.hpp"
#include "host/fractal/affine.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// A bounding volume in a shape's coordinates.
struct CompiledVolume {
    kernels::Volume kind = kernels::Volume::sphere;
    glm::dvec3 center{0.0};
    double radius = 0;  // sphere
    glm::dvec3 low{0.0};
    glm::dvec3 high{0.0};  // box
    double diameter = 0;
};

struct CompiledSet {
    CompiledVolume volume;
    std::vector<int> maps;
};

struct CompiledMap {
    Affine map;
    double constant = 0;  // by the shape's Lipschitz method
    glm::dvec4 color{0.0};
    int follow_set = 0;
    std::vector<glm::dvec3> lost;  // unit axes that the map squashed before it was lifted
};

/// A linear fractal with its volumes: the master object that objects are instances of. Its
/// coordinates are chosen such that its ball is about the unit ball.
struct CompiledShape {
    std::string ifs;
    std::vector<std::string> map_names;
    std::vector<CompiledMap> maps;
    std::vector<CompiledSet> sets;
    int start = 0;  // follow set of the outermost maps
    bool lifted = false;
    kernels::Lipschitz lipschitz = kernels::Lipschitz::product;
};

struct CompiledObject {
    std::string name;
    int shape = 0;
    Affine instance;  // shape to scene units
    double constant = 0;
    double diameter = 0;  // of the outermost volume, scene units
    glm::dvec3 color{0.0};
    double diffuse = 0;
    std::uint32_t levels = kernels::unlimited_levels;
};

struct CompiledLight {
    kernels::LightKind kind = kernels::LightKind::directional;
    glm::dvec3 place{0.0};
    glm::dvec3 color{1.0};
};

struct CompiledCamera {
    kernels::Projection projection = kernels::Projection::perspective;
    glm::dvec3 corner{0.0};
    glm::dvec3 across{0.0};
    glm::dvec3 down{0.0};
    glm::dvec3 forward{0.0};
    double pixel_at_eye = 0;  // p(t) = pixel_at_eye + pixel_growth t, Eq. 15.2
    double pixel_growth = 0;
};

struct CompiledScene {
    PixelSize size;
    CropWindow crop;
    std::vector<CompiledShape> shapes;
    std::vector<CompiledObject> objects;
    std::vector<CompiledLight> lights;
    CompiledCamera camera;
    kernels::ShadingMode shading = kernels::ShadingMode::constant;
    kernels::Method method = kernels::Method::heap;
    double detail = 1;
    std::uint32_t cell_cap = 1'000'000;  // most cells tested for one ray
    long heap = 256;
    glm::dvec3 ambient{0.2};
    glm::dvec3 background{0.02, 0.02, 0.03};
    double unit = 1;  // world length of one scene unit
};

}  // namespace pxm::host
