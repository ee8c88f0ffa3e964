// A scene ready for the nodes, still in double: maps with their inverses, volumes, graph, camera
// and lights, in scene units (the eye at the origin, scaled by a power of two).
// host/compile/compile makes it, host/node_program/write_scene_block rounds it to node words.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "dsp_kernels/scene_block.hpp"
#include "host/compiled/compiled_floor.hpp"
#include "host/fractal/bounds/polytope.hpp"
#include "host/math/affine.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// A bounding volume in a shape's coordinates.
struct CompiledVolume {
    kernels::Volume kind = kernels::Volume::sphere;
    glm::dvec3 center{0.0};
    double radius = 0;  // sphere, cone, cylinder
    glm::dvec3 low{0.0};
    glm::dvec3 high{0.0};                // box
    std::array<glm::dvec3, 3> half{};    // oriented: half edges, perpendicular
    std::vector<HalfSpace> half_spaces;  // hull
    double diameter = 0;
    bool operator==(const CompiledVolume&) const = default;
};

struct CompiledSet {
    CompiledVolume volume;
    std::vector<int> maps;
    double coverage = 1;  // mean share of rays through the volume that meet the attractor
};

struct CompiledMap {
    Affine map;
    double constant = 0;  // by the shape's Lipschitz method
    double least = 0;     // least diameter of its cell, as a share of the cell's around it
    glm::dvec4 color{0.0};
    int follow_set = 0;
    std::vector<glm::dvec3> lost;  // unit axes that the map squashed before it was lifted
};

/// A linear fractal with its volumes, or one volume without maps: the master object that objects
/// are instances of. Its coordinates are chosen such that its ball is about the unit ball.
struct CompiledShape {
    std::string ifs;  // empty: a volume that is an object itself
    std::vector<std::string> map_names;
    std::vector<CompiledMap> maps;
    std::vector<CompiledSet> sets;
    int start = 0;  // follow set of the outermost maps
    bool lifted = false;
    bool crowded = false;  // very many words lead to the same cells (host/node_program/crowded)
    kernels::Lipschitz lipschitz = kernels::Lipschitz::product;
};

/// An object, or a cell of one that is an object of its own because the eye is near it
/// (host/compile/reroot).
struct CompiledObject {
    std::string name;
    int origin = 0;  // number of the object in the scene
    int shape = 0;
    int start = 0;            // follow set of its outermost maps
    std::vector<int> prefix;  // the maps that lead to the cell, outermost first
    int enclosing = -1;       // the innermost cell around it that gives a normal, if any
    Affine instance;          // shape to scene units
    double constant = 0;
    double diameter = 0;  // of the outermost volume, scene units
    glm::dvec3 color{0.0};
    double diffuse = 0;
    double opacity = 1;  // of its volumes
    double reflect = 0;  // share of a mirror's image
    std::uint32_t levels = kernels::unlimited_levels;
};

/// A cell of an object whose cells became objects of their own. Nothing is looked for in it; rays
/// that enter it shade what they meet inside it by its normal, too (Ch. 17).
struct CompiledEnclosure {
    int enclosing = -1;     // the next one around it; the last is the object's outermost cell
    Affine inverse;         // from scene units
    CompiledVolume volume;  // its diameter in scene units
};

struct CompiledLight {
    kernels::LightKind kind = kernels::LightKind::directional;
    glm::dvec3 place{0.0};
    glm::dvec3 color{1.0};
    bool shadow = false;
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
    std::vector<CompiledEnclosure> enclosures;
    std::vector<CompiledPlane> planes;
    std::vector<CompiledTexture> textures;     // those that planes use
    std::vector<std::uint32_t> texture_words;  // the texture memory of every node
    std::vector<CompiledLight> lights;
    CompiledCamera camera;
    kernels::ShadingMode shading = kernels::ShadingMode::constant;
    kernels::Method method = kernels::Method::heap;
    double detail = 1;  // terminal at so many pixels; with covers tau_min
    double fade = 1;    // covers begin to show at so many pixels: tau_max
    bool covers = false;
    bool area = false;  // covers by area: `samples` are places in the beam of a pixel
    long bounces = 4;   // most mirrors one after another
    std::vector<glm::dvec2> samples{{0.5, 0.5}};  // places of a pixel's eye rays in it
    std::uint32_t cell_cap = 1'000'000;           // most cells tested for one ray
    long heap = 256;
    glm::dvec3 ambient{0.2};
    glm::dvec3 background{0.02, 0.02, 0.03};
    double unit = 1;  // world length of one scene unit
};

/// The objects that are cells of a scene's objects, and the longest word that leads to one.
struct Rerooted {
    std::size_t objects = 0;
    std::size_t levels = 0;
};
[[nodiscard]] Rerooted rerooted(const CompiledScene& scene);

/// How many objects the scene has itself, however many their cells have become.
[[nodiscard]] std::size_t object_count(const CompiledScene& scene);

/// What the tracer must do for a scene.
[[nodiscard]] bool needs_covers(const CompiledScene& scene);   // or has translucent objects
[[nodiscard]] bool needs_shadows(const CompiledScene& scene);  // has lights that cast them
[[nodiscard]] bool needs_mirrors(const CompiledScene& scene);
/// Nothing of these: the first cell along each eye ray is all that counts.
[[nodiscard]] bool needs_plain_features(const CompiledScene& scene);

}  // namespace pxm::host
