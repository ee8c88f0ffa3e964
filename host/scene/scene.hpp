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
    int file = 0;
    int line = 1;
    int column = 1;
    bool operator==(const Position&) const { return true; }  // not part of a scene's meaning
};

/// A source file that was read, for messages that show its lines.
struct SourceFile {
    std::string name;
    std::string text;
};

// --- commands of a map or an object; each post-multiplies in the order written -------------------
struct ScaleCommand {
    glm::dvec3 factors;
    bool operator==(const ScaleCommand&) const = default;
};
struct RotateCommand {
    Axis axis;
    double degrees;
    bool operator==(const RotateCommand&) const = default;
};
struct TranslateCommand {
    glm::dvec3 offset;
    bool operator==(const TranslateCommand&) const = default;
};
struct MatrixCommand {
    Affine map;
    bool operator==(const MatrixCommand&) const = default;
};
/// Sec. 9.3: the affine map taking each `from` to its `to`.
struct TetrahedronCommand {
    std::array<glm::dvec3, 4> from;
    std::array<glm::dvec3, 4> to;
    bool operator==(const TetrahedronCommand&) const = default;
};
/// A reference to a map: its name, or its number from 1.
struct MapReference {
    std::variant<std::string, long> map;
    Position position;
    bool operator==(const MapReference&) const = default;
};

/// Between two maps of the scene. A text that is read becomes a MatrixCommand of it
/// (host/scene/parse/resolve_blends.hpp): scenes elsewhere have none.
struct BlendEnd {
    std::string ifs;  // empty: the map's own
    MapReference map;
    bool operator==(const BlendEnd&) const = default;
};
struct BlendCommand {
    BlendEnd from;
    BlendEnd to;
    double share = 0;  // 0: `from`
    bool operator==(const BlendCommand&) const = default;
};
using CommandKind = std::variant<ScaleCommand, RotateCommand, TranslateCommand, MatrixCommand,
                                 TetrahedronCommand, BlendCommand>;
struct Command {
    CommandKind kind;
    Position position;
    bool operator==(const Command&) const = default;
};

struct MapBlock {
    std::string name;  // empty: known by its number only
    std::vector<Command> commands;
    std::optional<glm::dvec4> color;  // r,g,b,a: on entering the map c = (1-a) c + a (r,g,b)
    std::optional<double> weight;     // chaos game
    Position position;
    bool operator==(const MapBlock&) const = default;
};

struct FollowRule {
    MapReference map;
    std::vector<MapReference> followers;
    bool operator==(const FollowRule&) const = default;
};

struct IfsBlock {
    std::string name;
    std::vector<MapBlock> maps;
    std::vector<FollowRule> follow;
    std::vector<MapReference> start;
    Position position;
    bool operator==(const IfsBlock&) const = default;
};

// --- volumes -------------------------------------------------------------------------------------
struct SphereVolume {
    glm::dvec3 center{0.0};
    double radius = 1;
    bool operator==(const SphereVolume&) const = default;
};
struct BoxVolume {
    glm::dvec3 low{-1.0};
    glm::dvec3 high{1.0};
    bool operator==(const BoxVolume&) const = default;
};
struct ConeVolume {
    bool operator==(const ConeVolume&) const = default;
};
struct CylinderVolume {
    bool operator==(const CylinderVolume&) const = default;
};
struct HullVolume {
    bool operator==(const HullVolume&) const = default;
};
struct AutoVolume {
    bool operator==(const AutoVolume&) const = default;
};
using DeclaredVolume =
    std::variant<AutoVolume, SphereVolume, BoxVolume, ConeVolume, CylinderVolume, HullVolume>;

struct ObjectBlock {
    std::string name;
    std::optional<std::string> ifs;  // absent: the volume itself is the object
    Position ifs_position;
    std::optional<DeclaredVolume> volume;
    Position volume_position;
    std::vector<Command> commands;
    std::optional<glm::dvec4> color;
    std::optional<double> opacity;
    Position opacity_position;
    std::optional<double> diffuse;
    std::optional<double> reflect;
    Position reflect_position;
    std::optional<long> levels;
    Position position;
    bool operator==(const ObjectBlock&) const = default;
};

/// A reference to a texture by its name.
struct TextureReference {
    std::string name;
    Position position;
    bool operator==(const TextureReference&) const = default;
};

struct PlaneBlock {
    std::string name;
    std::optional<glm::dvec3> point;
    std::optional<glm::dvec3> normal;
    std::optional<glm::dvec3> color;
    std::vector<TextureReference> textures;  // laid over each other: their colours multiply
    std::optional<double> reflect;
    Position position;
    bool operator==(const PlaneBlock&) const = default;
};

struct FileTexture {
    std::string file;
    bool operator==(const FileTexture&) const = default;
};
struct IfsTexture {
    std::string ifs;
    bool operator==(const IfsTexture&) const = default;
};
struct WoodTexture {
    bool operator==(const WoodTexture&) const = default;
};
struct TextureBlock {
    std::string name;
    std::optional<std::variant<FileTexture, IfsTexture, WoodTexture>> source;
    Position source_position;
    std::optional<glm::dvec2> size;
    std::optional<glm::dvec3> color;
    std::optional<glm::dvec3> color2;
    Position position;
    bool operator==(const TextureBlock&) const = default;
};

struct LightBlock {
    std::string name;
    std::optional<glm::dvec3> direction;  // from the surface to the light
    std::optional<glm::dvec3> location;   // written `position:`
    std::optional<glm::dvec3> color;
    std::optional<bool> shadow;
    Position shadow_position;
    Position position;
    bool operator==(const LightBlock&) const = default;
};

struct CameraBlock {
    std::string name;
    std::optional<DecimalVec3> eye;
    std::optional<DecimalVec3> look;
    std::optional<glm::dvec3> up;
    std::optional<double> fov;           // degrees, horizontal
    std::optional<double> orthographic;  // width in world units
    std::optional<double> zoom;          // the eye moves to look + (eye - look) / zoom
    Position position;
    bool operator==(const CameraBlock&) const = default;
};

// --- image and render: each value may also come from the command line, which wins
// -----------------
struct PixelSize {
    long columns = 640;
    long rows = 480;
    bool operator==(const PixelSize&) const = default;
};
/// Half open: x0 <= x < x1, y0 <= y < y1.
struct CropWindow {
    long x0 = 0;
    long y0 = 0;
    long x1 = 0;
    long y1 = 0;
    bool operator==(const CropWindow&) const = default;
};
struct ImageBlock {
    std::optional<PixelSize> size;
    std::optional<CropWindow> crop;
    Position position;
    bool operator==(const ImageBlock&) const = default;
};

/// A film: `t` and `frame` in expressions are those of one of its frames when the text is read.
struct AnimationBlock {
    long frames = 1;
    double rate = 25;    // frames a second
    double shutter = 0;  // the share of a frame's time that its samples are spread over
    Position position;
    bool operator==(const AnimationBlock&) const = default;
};

enum class Shading { constant, low_pass, high_pass, facet };
enum class IntersectMethod { automatic, heap, fast, wide };
enum class Numeric { dsp32, single, double_ };  // dsp32, float, double
enum class LipschitzMethod { automatic, product, determinant, polar };
enum class VolumeKind { automatic, sphere, box, oriented, hull };
/// Opacity bandwidth of local covers, in pixels (Ch. 18).
struct Covers {
    double tau_min = 1.0 / 20;
    double tau_max = 2;
    bool operator==(const Covers&) const = default;
};
struct CoversOff {
    bool operator==(const CoversOff&) const = default;
};
/// One search a pixel for what covers several places in it, instead of opacity by diameter.
struct AreaCovers {
    bool operator==(const AreaCovers&) const = default;
};
using CoversChoice = std::variant<CoversOff, Covers, AreaCovers>;

struct RenderBlock {
    std::optional<glm::dvec3> ambient;
    std::optional<glm::dvec3> background;
    std::optional<Shading> shading;
    std::optional<CoversChoice> covers;
    std::optional<long> samples;
    std::optional<IntersectMethod> intersect;
    std::optional<Numeric> numeric;
    std::optional<double> detail;
    std::optional<LipschitzMethod> lipschitz;
    std::optional<VolumeKind> volume;
    std::optional<long> heap;
    std::optional<long> bounces;
    Position position;         // of the block
    Position covers_position;  // of directives that may not be supported yet
    Position samples_position;
    Position intersect_position;
    Position numeric_position;
    Position volume_position;
    bool operator==(const RenderBlock&) const = default;
};

/// Everything one scene file and its includes say.
struct Scene {
    std::vector<SourceFile> files;
    std::vector<IfsBlock> ifs;
    std::vector<ObjectBlock> objects;
    std::vector<PlaneBlock> planes;
    std::vector<TextureBlock> textures;
    std::vector<LightBlock> lights;
    std::optional<CameraBlock> camera;
    std::optional<ImageBlock> image;
    std::optional<RenderBlock> render;
    std::optional<AnimationBlock> animation;

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
