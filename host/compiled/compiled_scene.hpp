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
    kernels::Volume kind = kernels::Volume::sphere;  // which of the members below count
    glm::dvec3 center{0.0};                          // of all kinds but the box along the axes
    double radius = 0;                               // sphere, cone, cylinder
    glm::dvec3 low{0.0};                             // box: its corners
    glm::dvec3 high{0.0};                            // box
    std::array<glm::dvec3, 3> half{};                // oriented: half edges, perpendicular
    std::vector<HalfSpace> half_spaces;              // hull
    double diameter = 0;  // the largest distance of two points, in the shape's units
    bool operator==(const CompiledVolume&) const = default;
};

struct CompiledSet {        // what may stand inside a map
    CompiledVolume volume;  // around all of it
    std::vector<int> maps;  // that may come next: indices into CompiledShape::maps
    double coverage = 1;    // mean share of rays through the volume that meet the attractor
};

struct CompiledMap {               // one map of a shape
    Affine map;                    // in the shape's coordinates
    double constant = 0;           // by the shape's Lipschitz method
    double least = 0;              // least diameter of its cell, as a share of the cell's around it
    glm::dvec4 color{0.0};         // r, g, b and the share of them
    int follow_set = 0;            // of what stands inside it: an index into CompiledShape::sets
    std::vector<glm::dvec3> lost;  // unit axes that the map squashed before it was lifted
};

/// A linear fractal with its volumes, or one volume without maps: the master object that objects
/// are instances of. Its coordinates are chosen such that its ball is about the unit ball.
struct CompiledShape {
    std::string ifs;                     // empty: a volume that is an object itself
    std::vector<std::string> map_names;  // one of each map
    std::vector<CompiledMap> maps;       // of the system
    std::vector<CompiledSet> sets;       // its follow sets; of a volume without maps one
    int start = 0;                       // follow set of the outermost maps
    bool lifted = false;                 // some maps were singular, and have been made regular
    bool crowded = false;  // very many words lead to the same cells (host/node_program/crowded)
    /// How diameters of cells are estimated.
    kernels::Lipschitz lipschitz = kernels::Lipschitz::product;
};

/// An object, or a cell of one that is an object of its own because the eye is near it
/// (host/compile/reroot).
struct CompiledObject {
    std::string name;         // as the scene calls it
    int origin = 0;           // number of the object in the scene
    int shape = 0;            // an index into CompiledScene::shapes
    int start = 0;            // follow set of its outermost maps
    std::vector<int> prefix;  // the maps that lead to the cell, outermost first
    int enclosing = -1;       // the innermost cell around it that gives a normal, if any
    Affine instance;          // shape to scene units
    double constant = 0;      // the Lipschitz constant of `instance`
    double diameter = 0;      // of the outermost volume, scene units
    glm::dvec3 color{0.0};    // linear
    double diffuse = 0;       // share of diffuse reflection, 0 to 1
    double opacity = 1;       // of its volumes
    double reflect = 0;       // share of a mirror's image
    std::uint32_t levels = kernels::unlimited_levels;  // stop after so many maps
};

/// A cell of an object whose cells became objects of their own. Nothing is looked for in it; rays
/// that enter it shade what they meet inside it by its normal, too (Ch. 17).
struct CompiledEnclosure {
    int enclosing = -1;     // the next one around it; the last is the object's outermost cell
    Affine inverse;         // from scene units
    CompiledVolume volume;  // its diameter in scene units
};

struct CompiledLight {                                          // a light, in scene units
    kernels::LightKind kind = kernels::LightKind::directional;  // how far away it is
    glm::dvec3 place{0.0};  // a unit vector to it, or where it stands
    glm::dvec3 color{1.0};  // linear
    bool shadow = false;    // whether it casts shadows
};

struct CompiledCamera {  // where eye rays go: from 0 through corner + x across + y down
    /// Whether rays meet in the eye.
    kernels::Projection projection = kernels::Projection::perspective;
    glm::dvec3 corner{0.0};   // of the picture: the upper left one of pixel (0, 0)
    glm::dvec3 across{0.0};   // from a pixel to the one on its right
    glm::dvec3 down{0.0};     // from a pixel to the one below
    glm::dvec3 forward{0.0};  // the unit vector along the view
    double pixel_at_eye = 0;  // p(t) = pixel_at_eye + pixel_growth t, Eq. 15.2
    double pixel_growth = 0;  // a scene unit of the way
};

struct CompiledScene {                          // all that the nodes are told
    PixelSize size;                             // of the image, in pixels
    CropWindow crop;                            // what of it is rendered
    std::vector<CompiledShape> shapes;          // that objects are instances of
    std::vector<CompiledObject> objects;        // in the order of the scene
    std::vector<CompiledEnclosure> enclosures;  // that objects lie in whose cells became objects
    std::vector<CompiledPlane> planes;          // floors and walls
    std::vector<CompiledTexture> textures;      // those that planes use
    std::vector<std::uint32_t> texture_words;   // the texture memory of every node
    std::vector<CompiledLight> lights;          // all that shine
    CompiledCamera camera;                      // of the eye rays
    kernels::ShadingMode shading = kernels::ShadingMode::constant;  // how normals are weighted
    kernels::Method method = kernels::Method::heap;                 // how the first hit is found
    double detail = 1;    // terminal at so many pixels; with covers tau_min
    double fade = 1;      // covers begin to show at so many pixels: tau_max
    bool covers = false;  // local covers, by `detail` and `fade`
    bool area = false;    // covers by area: `samples` are places in the beam of a pixel
    long bounces = 4;     // most mirrors one after another
    std::vector<glm::dvec2> samples{{0.5, 0.5}};  // places of a pixel's eye rays in it
    std::uint32_t cell_cap = 1'000'000;           // most cells tested for one ray
    long heap = 256;                              // entries
    glm::dvec3 ambient{0.2};                      // linear light from everywhere
    glm::dvec3 background{0.02, 0.02, 0.03};      // linear colour where nothing is hit
    double unit = 1;                              // world length of one scene unit
};

/// The objects that are cells of a scene's objects, and the longest word that leads to one.
struct Rerooted {
    std::size_t objects = 0;  // those that are cells
    std::size_t levels = 0;   // maps on the way to the smallest of them
};
[[nodiscard]] Rerooted rerooted(const CompiledScene& scene);  // counts them

/// How many objects the scene has itself, however many their cells have become.
[[nodiscard]] std::size_t object_count(const CompiledScene& scene);

/// What the tracer must do for a scene.
[[nodiscard]] bool needs_covers(const CompiledScene& scene);   // or has translucent objects
[[nodiscard]] bool needs_shadows(const CompiledScene& scene);  // has lights that cast them
/// Or has objects or planes that reflect.
[[nodiscard]] bool needs_mirrors(const CompiledScene& scene);
/// Nothing of these: the first cell along each eye ray is all that counts.
[[nodiscard]] bool needs_plain_features(const CompiledScene& scene);

}  // namespace pxm::host
