// A scene as the text says it: blocks, directives and values, names still names
// (docs/scene-language.md). What is left out stays empty here; defaults are filled in by the
// compiler (host/compile/compile). Equality ignores positions in the source, so that
// parse(print(scene)) == scene can be tested.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "host/math/affine.hpp"
#include "host/math/decimal.hpp"

namespace pxm::host {

/// A place in the source: index of the file in Scene::files, line and column from 1.
struct Position {
    int file = 0;                                            // of Scene::files
    int line = 1;                                            // from 1
    int column = 1;                                          // in bytes, from 1
    bool operator==(const Position&) const { return true; }  // not part of a scene's meaning
};

/// A source file that was read, for messages that show its lines.
struct SourceFile {
    std::string name;  // as messages call it
    std::string text;  // all of it
};

// --- commands of a map or an object; each post-multiplies in the order written -------------------
struct ScaleCommand {    // stretches the axes
    glm::dvec3 factors;  // of x, y and z
    bool operator==(const ScaleCommand&) const = default;
};
struct RotateCommand {  // turns about an axis
    Axis axis;          // the one that stands still
    double degrees;     // from the axis after it to the next
    bool operator==(const RotateCommand&) const = default;
};
struct TranslateCommand {  // moves
    glm::dvec3 offset;     // in world units
    bool operator==(const TranslateCommand&) const = default;
};
struct MatrixCommand {  // any affine map
    Affine map;         // as it is written
    bool operator==(const MatrixCommand&) const = default;
};
/// Sec. 9.3: the affine map taking each `from` to its `to`.
struct TetrahedronCommand {
    std::array<glm::dvec3, 4> from;  // the four corners
    std::array<glm::dvec3, 4> to;    // and where they go
    bool operator==(const TetrahedronCommand&) const = default;
};
/// A reference to a map: its name, or its number from 1.
struct MapReference {
    std::variant<std::string, long> map;  // its name, or its number
    Position position;                    // where it is written
    bool operator==(const MapReference&) const = default;
};

/// Between two maps of the scene. A text that is read becomes a MatrixCommand of it
/// (host/scene/parse/resolve_blends.hpp): scenes elsewhere have none.
struct BlendEnd {
    std::string ifs;   // empty: the map's own
    MapReference map;  // one of that ifs
    bool operator==(const BlendEnd&) const = default;
};
struct BlendCommand {  // a map on the way between two
    BlendEnd from;     // the map at share 0
    BlendEnd to;       // the map at share 1
    double share = 0;  // 0: `from`
    bool operator==(const BlendCommand&) const = default;
};
/// One step of a map, of whatever kind.
using CommandKind = std::variant<ScaleCommand, RotateCommand, TranslateCommand, MatrixCommand,
                                 TetrahedronCommand, BlendCommand>;
struct Command {        // one step of a map
    CommandKind kind;   // which, and with what numbers
    Position position;  // of the word that it begins with
    bool operator==(const Command&) const = default;
};

struct MapBlock {                     // one map of a system
    std::string name;                 // empty: known by its number only
    std::vector<Command> commands;    // in the order written
    std::optional<glm::dvec4> color;  // r,g,b,a: on entering the map c = (1-a) c + a (r,g,b)
    std::optional<double> weight;     // of the chaos game, 0 or more
    Position position;                // of the word that it begins with
    bool operator==(const MapBlock&) const = default;
};

struct FollowRule {                       // what may stand inside a map
    MapReference map;                     // the outer one
    std::vector<MapReference> followers;  // those that may come in it
    bool operator==(const FollowRule&) const = default;
};

struct IfsBlock {                     // a system
    std::string name;                 // by which objects call it
    std::vector<MapBlock> maps;       // in the order written
    std::vector<FollowRule> follow;   // empty: all may follow all
    std::vector<MapReference> start;  // empty: the default of the language
    Position position;                // of the word that it begins with
    bool operator==(const IfsBlock&) const = default;
};

// --- volumes -------------------------------------------------------------------------------------
struct SphereVolume {        // a ball
    glm::dvec3 center{0.0};  // its middle
    double radius = 1;       // greater than 0
    bool operator==(const SphereVolume&) const = default;
};
struct BoxVolume {         // a box along the axes
    glm::dvec3 low{-1.0};  // the corner with the least of each coordinate
    glm::dvec3 high{1.0};  // and that with the greatest
    bool operator==(const BoxVolume&) const = default;
};
struct ConeVolume {  // radius 1 at y = 0, apex at (0,1,0)
    bool operator==(const ConeVolume&) const = default;
};
struct CylinderVolume {  // radius 1, from y = -1 to y = 1
    bool operator==(const CylinderVolume&) const = default;
};
struct HullVolume {  // an intersection of half-spaces, which is computed
    bool operator==(const HullVolume&) const = default;
};
struct AutoVolume {  // the kind is found by trial
    bool operator==(const AutoVolume&) const = default;
};
/// The volume of an object, as the scene says it.
using DeclaredVolume =
    std::variant<AutoVolume, SphereVolume, BoxVolume, ConeVolume, CylinderVolume, HullVolume>;

struct ObjectBlock {                       // what is shown, and where
    std::string name;                      // empty: none was given
    std::optional<std::string> ifs;        // absent: the volume itself is the object
    Position ifs_position;                 // of the name of the ifs
    std::optional<DeclaredVolume> volume;  // its bounding volume
    Position volume_position;              // of its word
    std::vector<Command> commands;         // they place it in the world
    std::optional<glm::dvec4> color;       // r,g,b,a over the base color
    std::optional<double> opacity;         // 0 to 1; below 1 its volumes are translucent
    Position opacity_position;             // of its number
    std::optional<double> diffuse;         // share of diffuse reflection, 0 to 1
    std::optional<double> reflect;         // share of a mirror image, 0 to 1
    Position reflect_position;             // of its number
    std::optional<long> levels;            // stop after so many maps, 0 or more
    Position position;                     // of the word that it begins with
    bool operator==(const ObjectBlock&) const = default;
};

/// A reference to a texture by its name.
struct TextureReference {
    std::string name;   // of the texture
    Position position;  // where it is written
    bool operator==(const TextureReference&) const = default;
};

struct PlaneBlock {                          // an endless floor or wall
    std::string name;                        // empty: none was given
    std::optional<glm::dvec3> point;         // one that it goes through
    std::optional<glm::dvec3> normal;        // across it
    std::optional<glm::dvec3> color;         // linear
    std::vector<TextureReference> textures;  // laid over each other: their colours multiply
    std::optional<double> reflect;           // share of a mirror image, 0 to 1
    Position position;                       // of the word that it begins with
    bool operator==(const PlaneBlock&) const = default;
};

struct FileTexture {   // a picture
    std::string file;  // its path, from the file that names it
    bool operator==(const FileTexture&) const = default;
};
struct IfsTexture {   // a flat attractor
    std::string ifs;  // its system
    bool operator==(const IfsTexture&) const = default;
};
struct WoodTexture {  // boards
    bool operator==(const WoodTexture&) const = default;
};
struct TextureBlock {  // what a plane may be covered with
    std::string name;  // by which planes call it
    std::optional<std::variant<FileTexture, IfsTexture, WoodTexture>> source;  // what it shows
    Position source_position;                                                  // of its word
    std::optional<glm::dvec2> size;    // of one repeat, in world units
    std::optional<glm::dvec3> color;   // of what it shows
    std::optional<glm::dvec3> color2;  // of what is between
    Position position;                 // of the word that it begins with
    bool operator==(const TextureBlock&) const = default;
};

struct LightBlock {                       // a light
    std::string name;                     // empty: none was given
    std::optional<glm::dvec3> direction;  // from the surface to the light
    std::optional<glm::dvec3> location;   // written `position:`
    std::optional<glm::dvec3> color;      // linear
    std::optional<bool> shadow;           // whether it casts shadows
    Position shadow_position;             // of its word
    Position position;                    // of the word that it begins with
    bool operator==(const LightBlock&) const = default;
};

struct CameraBlock {                     // where the picture is taken from
    std::string name;                    // empty: none was given
    std::optional<DecimalVec3> eye;      // where it stands
    std::optional<DecimalVec3> look;     // what it looks at
    std::optional<glm::dvec3> up;        // what is upward in the picture
    std::optional<double> fov;           // degrees, horizontal
    std::optional<double> orthographic;  // width in world units
    std::optional<double> zoom;          // the eye moves to look + (eye - look) / zoom
    Position position;                   // of the word that it begins with
    bool operator==(const CameraBlock&) const = default;
};

// --- image and render: each value may also come from the command line, which wins
// -----------------
struct PixelSize {       // of a picture
    long columns = 640;  // pixels from left to right
    long rows = 480;     // pixels from top to bottom
    bool operator==(const PixelSize&) const = default;
};
/// Half open: x0 <= x < x1, y0 <= y < y1.
struct CropWindow {
    long x0 = 0;  // the first column
    long y0 = 0;  // the first row
    long x1 = 0;  // one beyond the last column
    long y1 = 0;  // one beyond the last row
    bool operator==(const CropWindow&) const = default;
};
struct ImageBlock {                  // the picture to be made
    std::optional<PixelSize> size;   // in pixels
    std::optional<CropWindow> crop;  // what of it is rendered
    Position position;               // of the word that it begins with
    bool operator==(const ImageBlock&) const = default;
};

/// A film: `t` and `frame` in expressions are those of one of its frames when the text is read.
struct AnimationBlock {
    long frames = 1;     // how many there are
    double rate = 25;    // frames a second
    double shutter = 0;  // the share of a frame's time that its samples are spread over
    Position position;   // of the word that it begins with
    bool operator==(const AnimationBlock&) const = default;
};

/// How the normals of a path's cells are weighted (Ch. 17).
enum class Shading { constant, low_pass, high_pass, facet };
enum class IntersectMethod { automatic, heap, fast, wide };  // how the first hit is found
/// What nodes compute with: dsp32, float or double.
enum class Numeric { dsp32, single, double_ };
/// How diameters of cells are estimated (Ch. 16).
enum class LipschitzMethod { automatic, product, determinant, polar };
/// Bounding volumes of all objects.
enum class VolumeKind { automatic, sphere, box, oriented, hull };
/// Opacity bandwidth of local covers, in pixels (Ch. 18).
struct Covers {
    double tau_min = 1.0 / 20;  // smaller cells are transparent
    double tau_max = 2;         // larger cells are opaque
    bool operator==(const Covers&) const = default;
};
struct CoversOff {  // none
    bool operator==(const CoversOff&) const = default;
};
/// One search a pixel for what covers several places in it, instead of opacity by diameter.
struct AreaCovers {
    bool operator==(const AreaCovers&) const = default;
};
using CoversChoice = std::variant<CoversOff, Covers, AreaCovers>;  // how edges are smoothed

struct RenderBlock {                           // how it is rendered
    std::optional<glm::dvec3> ambient;         // light from everywhere
    std::optional<glm::dvec3> background;      // where nothing is hit
    std::optional<Shading> shading;            // how normals are weighted
    std::optional<CoversChoice> covers;        // local covers
    std::optional<long> samples;               // eye rays a pixel, 1 to 65,536
    std::optional<IntersectMethod> intersect;  // how the first hit is found
    std::optional<Numeric> numeric;            // what nodes compute with
    std::optional<double> detail;              // a cell is small enough at so many pixels
    std::optional<LipschitzMethod> lipschitz;  // how diameters are estimated
    std::optional<VolumeKind> volume;          // of all objects
    std::optional<long> heap;                  // entries, 1 to 65,536
    std::optional<long> bounces;               // mirror reflections a ray may take, 0 to 64
    Position position;                         // of the block
    Position covers_position;                  // of directives that may not be supported yet
    Position samples_position;                 // of its number
    Position intersect_position;               // of its word
    Position numeric_position;                 // of its word
    Position volume_position;                  // of its word
    bool operator==(const RenderBlock&) const = default;
};

/// Everything one scene file and its includes say.
struct Scene {
    std::vector<SourceFile> files;            // that it was read from
    std::vector<IfsBlock> ifs;                // in the order written, as all blocks
    std::vector<ObjectBlock> objects;         // empty: every system is shown
    std::vector<PlaneBlock> planes;           // floors and walls
    std::vector<TextureBlock> textures;       // of the planes
    std::vector<LightBlock> lights;           // empty: one from above
    std::optional<CameraBlock> camera;        // absent: in front of what is shown
    std::optional<ImageBlock> image;          // absent: all of its defaults
    std::optional<RenderBlock> render;        // absent: all of its defaults
    std::optional<AnimationBlock> animation;  // absent: it is no film

    /// The same whatever files it was read from: an include leaves no trace.
    bool operator==(const Scene& other) const {
        const auto blocks = [](const Scene& s) {
            return std::tie(s.ifs, s.objects, s.planes, s.textures, s.lights, s.camera, s.image,
                            s.render, s.animation);
        };
        return blocks(*this) == blocks(other);
    }
};

/// The affine map that a list of commands composes to, in the order written.
/// A flat `from` tetrahedron throws std::domain_error (the checker reports it with its position).
[[nodiscard]] Affine compose(const std::vector<Command>& commands);

}  // namespace pxm::host
