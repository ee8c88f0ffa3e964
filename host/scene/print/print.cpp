// Text of every part of a scene, and the blocks in the order a reader wants them.
#include "host/scene/print/print.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <span>

#include "host/scene/words.hpp"

namespace pxm::host {
namespace {

/// The shortest text that reads back as the same double.
std::string text_of(double value) {
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}
std::string text_of(const Decimal& number) {
    return number.text.empty() ? text_of(number.value) : number.text;
}
std::string text_of(const glm::dvec2& v) { return text_of(v.x) + "," + text_of(v.y); }
std::string text_of(const glm::dvec3& v) {
    return text_of(v.x) + "," + text_of(v.y) + "," + text_of(v.z);
}
std::string text_of(const glm::dvec4& v) { return text_of(glm::dvec3(v)) + "," + text_of(v.w); }
std::string text_of(const DecimalVec3& v) {
    return text_of(v[0]) + "," + text_of(v[1]) + "," + text_of(v[2]);
}
std::string point_of(const glm::dvec3& v) { return fmt::format("({})", text_of(v)); }
std::string points_of(const std::array<glm::dvec3, 4>& points) {
    std::string text;
    for (const glm::dvec3& point : points) text += point_of(point);
    return text;
}
std::string text_of(const MapReference& reference) {
    if (const auto* name = std::get_if<std::string>(&reference.map)) return *name;
    return std::to_string(std::get<long>(reference.map));
}
std::string text_of(const std::vector<MapReference>& references) {
    std::string text;
    for (const MapReference& reference : references)
        text += (text.empty() ? "" : ", ") + text_of(reference);
    return text;
}

struct CommandText {
    std::string operator()(const ScaleCommand& c) const { return "scale: " + text_of(c.factors); }
    std::string operator()(const RotateCommand& c) const {
        return fmt::format("rotate: {},{}", word_of(axis_words, c.axis), text_of(c.degrees));
    }
    std::string operator()(const TranslateCommand& c) const {
        return "translate: " + text_of(c.offset);
    }
    std::string operator()(const MatrixCommand& c) const {
        const Affine& m = c.map;
        return fmt::format("matrix: {}, {}, {}, {}", text_of(m.linear[0]), text_of(m.linear[1]),
                           text_of(m.linear[2]), text_of(m.translation));
    }
    std::string operator()(const TetrahedronCommand& c) const {
        return fmt::format("tetrahedron: {} -> {}", points_of(c.from), points_of(c.to));
    }
    std::string operator()(const BlendCommand& c) const {
        const auto end = [](const BlendEnd& e) {
            return (e.ifs.empty() ? "" : e.ifs + " ") + text_of(e.map);
        };
        return fmt::format("blend: {} -> {}, {}", end(c.from), end(c.to), text_of(c.share));
    }
};

struct VolumeText {
    std::string operator()(const AutoVolume&) const { return "auto"; }
    std::string operator()(const SphereVolume& v) const {
        return fmt::format("sphere: {} {}", point_of(v.center), text_of(v.radius));
    }
    std::string operator()(const BoxVolume& v) const {
        return fmt::format("box: {}{}", point_of(v.low), point_of(v.high));
    }
    std::string operator()(const ConeVolume&) const { return "cone"; }
    std::string operator()(const CylinderVolume&) const { return "cylinder"; }
    std::string operator()(const HullVolume&) const { return "hull"; }
};

struct SourceText {
    std::string operator()(const FileTexture& t) const {
        return fmt::format("file: \"{}\"", t.file);
    }
    std::string operator()(const IfsTexture& t) const { return "ifs: " + t.ifs; }
    std::string operator()(const WoodTexture&) const { return "wood"; }
};

struct CoversText {
    std::string operator()(const CoversOff&) const { return "off"; }
    std::string operator()(const AreaCovers&) const { return "area"; }
    std::string operator()(const Covers& c) const {
        return text_of(c.tau_min) + "," + text_of(c.tau_max);
    }
};

/// Writes one directive a line inside blocks.
class ScenePrinter {
  public:
    std::string print(const Scene& scene) {
        if (scene.animation) animation(*scene.animation);
        if (scene.image) image(*scene.image);
        if (scene.render) render(*scene.render);
        if (scene.camera) camera(*scene.camera);
        for (const LightBlock& block : scene.lights) light(block);
        for (const TextureBlock& block : scene.textures) texture(block);
        for (const PlaneBlock& block : scene.planes) plane(block);
        for (const IfsBlock& block : scene.ifs) ifs(block);
        for (const ObjectBlock& block : scene.objects) object(block);
        return std::move(text_);
    }

  private:
    void open(std::string_view kind, const std::string& name = {}) {
        if (!text_.empty()) text_ += '\n';
        text_ +=
            name.empty() ? fmt::format("{} {{\n", kind) : fmt::format("{} {} {{\n", kind, name);
    }
    void line(const std::string& directive) { text_ += "    " + directive + "\n"; }
    void close() { text_ += "}\n"; }

    template <class Value>
    void optional(std::string_view word, const std::optional<Value>& value) {
        if (!value) return;
        if constexpr (std::is_integral_v<Value>)
            line(fmt::format("{}: {}", word, *value));
        else
            line(fmt::format("{}: {}", word, text_of(*value)));
    }
    template <class Words, class Value>
    void optional(std::string_view word, const std::optional<Value>& value, const Words& words) {
        if (value) line(fmt::format("{}: {}", word, word_of(words, *value)));
    }
    void commands(const std::vector<Command>& list, const char* indent) {
        for (const Command& command : list) line(indent + std::visit(CommandText{}, command.kind));
    }

    void ifs(const IfsBlock& block) {
        open("ifs", block.name);
        for (const MapBlock& map : block.maps) {
            line(map.name.empty() ? "newmap" : "newmap " + map.name);
            commands(map.commands, "    ");
            optional("    color", map.color);
            optional("    weight", map.weight);
        }
        for (const FollowRule& rule : block.follow)
            line(fmt::format("follow: {} -> {}", text_of(rule.map), text_of(rule.followers)));
        if (!block.start.empty()) line("start: " + text_of(block.start));
        close();
    }

    void object(const ObjectBlock& block) {
        open("object", block.name);
        if (block.ifs) line("ifs: " + *block.ifs);
        if (block.volume) line(std::visit(VolumeText{}, *block.volume));
        commands(block.commands, "");
        optional("color", block.color);
        optional("opacity", block.opacity);
        optional("diffuse", block.diffuse);
        optional("reflect", block.reflect);
        optional("levels", block.levels);
        close();
    }

    void plane(const PlaneBlock& block) {
        open("plane", block.name);
        optional("point", block.point);
        optional("normal", block.normal);
        optional("color", block.color);
        std::string textures;
        for (const TextureReference& texture : block.textures) {
            textures += (textures.empty() ? "texture: " : ", ") + texture.name;
        }
        if (!textures.empty()) line(textures);
        optional("reflect", block.reflect);
        close();
    }

    void texture(const TextureBlock& block) {
        open("texture", block.name);
        if (block.source) line(std::visit(SourceText{}, *block.source));
        optional("size", block.size);
        optional("color", block.color);
        optional("color2", block.color2);
        close();
    }

    void light(const LightBlock& block) {
        open("light", block.name);
        optional("direction", block.direction);
        optional("position", block.location);
        optional("color", block.color);
        optional("shadow", block.shadow, switch_words);
        close();
    }

    void camera(const CameraBlock& block) {
        open("camera", block.name);
        optional("eye", block.eye);
        optional("look", block.look);
        optional("up", block.up);
        optional("fov", block.fov);
        optional("orthographic", block.orthographic);
        optional("zoom", block.zoom);
        close();
    }

    void animation(const AnimationBlock& block) {
        open("animation");
        line(fmt::format("frames: {}", block.frames));
        line("rate: " + text_of(block.rate));
        line("shutter: " + text_of(block.shutter));
        close();
    }

    void image(const ImageBlock& block) {
        open("image");
        if (block.size) line(fmt::format("size: {},{}", block.size->columns, block.size->rows));
        if (const auto& crop = block.crop)
            line(fmt::format("crop: {},{},{},{}", crop->x0, crop->y0, crop->x1, crop->y1));
        close();
    }

    void render(const RenderBlock& block) {
        open("render");
        optional("ambient", block.ambient);
        optional("background", block.background);
        optional("shading", block.shading, shading_words);
        if (block.covers) line("covers: " + std::visit(CoversText{}, *block.covers));
        optional("samples", block.samples);
        optional("intersect", block.intersect, intersect_words);
        optional("numeric", block.numeric, numeric_words);
        optional("detail", block.detail);
        optional("lipschitz", block.lipschitz, lipschitz_words);
        optional("volume", block.volume, volume_words);
        optional("heap", block.heap);
        optional("bounces", block.bounces);
        close();
    }

    std::string text_;
};

}  // namespace

std::string print_scene(const Scene& scene) { return ScenePrinter{}.print(scene); }

}  // namespace pxm::host
