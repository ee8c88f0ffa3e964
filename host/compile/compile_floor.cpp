#include "host/compile/compile_floor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "dsp_kernels/texture_wood.hpp"
#include "host/compile/compile_flat_ifs.hpp"
#include "host/compile/image_levels.hpp"
#include "host/error.hpp"
#include "host/files/image_reader.hpp"
#include "host/scene/check/limits.hpp"
#include "host/scene/check/range_check.hpp"
#include "host/scene/picture_path.hpp"

namespace pxm::host {

namespace {

constexpr double largest_length = 1e100;  // world units, as of objects
constexpr glm::dvec3 base_color{0.9, 0.9, 0.9};
constexpr double base_diffuse = 0.8;
constexpr glm::dvec2 board_size{2, 0.25};
constexpr glm::dvec3 light_wood{0.60, 0.36, 0.16};
constexpr glm::dvec3 dark_wood{0.20, 0.085, 0.03};
constexpr glm::dvec3 inlay_color{0.2, 0.2, 0.2};

/// A unit vector, whatever the length was.
glm::dvec3 unit_vector(const glm::dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return glm::normalize(v / largest);
}

/// The directions of u and v on a plane: v goes up a wall, and along z on a floor or ceiling; u
/// goes to the right of v as seen from the side the normal points to.
struct PlaneAxes {
    glm::dvec3 u;
    glm::dvec3 v;
};

PlaneAxes axes_of(const glm::dvec3& normal) {
    const bool lies = std::abs(normal.y) > std::numbers::sqrt2 / 2;
    const glm::dvec3 wanted = lies ? glm::dvec3{0, 0, 1} : glm::dvec3{0, 1, 0};
    const glm::dvec3 v = glm::normalize(wanted - glm::dot(wanted, normal) * normal);
    return {glm::cross(normal, v), v};
}

/// What a texture is, and the size of one repeat of it in world units.
struct SizedTexture {
    CompiledTexture texture;
    glm::dvec2 size{1.0};
};

class FloorCompiler {
  public:
    FloorCompiler(const Scene& scene, const View& view,
                  const std::map<std::string, Fractal>& fractals, CompiledScene& out,
                  Diagnostics& diagnostics)
        : scene_(scene), view_(view), fractals_(fractals), out_(out), diagnostics_(diagnostics) {}

    void run() {
        for (const PlaneBlock& plane : scene_.planes) add_plane(plane);
    }

  private:
    void add_plane(const PlaneBlock& block) {
        CompiledPlane plane;
        plane.name = block.name;
        plane.normal = unit_vector(*block.normal);
        const glm::dvec3 point = block.point.value_or(glm::dvec3{0.0});
        if (!(glm::length(point) <= largest_length)) {
            diagnostics_.error(block.position,
                               fmt::format("{} is too far away: its point lies beyond {:g}",
                                           block_name("plane", block.name), largest_length));
            return;
        }
        const glm::dvec3 from_eye = point - view_.eye;
        plane.offset = glm::dot(from_eye, plane.normal) / out_.unit;
        plane.color = block.color.value_or(block.textures.empty() ? base_color : glm::dvec3{1.0});
        plane.diffuse = base_diffuse;
        plane.reflect = block.reflect.value_or(0);
        for (const TextureReference& reference : block.textures) {
            const int texture = texture_named(reference.name);
            if (texture < 0) return;
            plane.layers.push_back(lay(texture, from_eye, axes_of(plane.normal)));
        }
        out_.planes.push_back(std::move(plane));
    }

    /// A texture on a plane: the repeat that has a corner at the plane's point, moved by whole
    /// repeats to below the eye, where numbers have the most digits.
    CompiledLayer lay(int texture, const glm::dvec3& from_eye, const PlaneAxes& axes) const {
        const glm::dvec2 size = sizes_[static_cast<std::size_t>(texture)] / out_.unit;
        const glm::dvec3 corner = from_eye / out_.unit;
        CompiledLayer layer;
        layer.texture = texture;
        layer.across = axes.u / size.x;
        layer.along = axes.v / size.y;
        const double u = std::floor(-glm::dot(corner, layer.across));
        const double v = std::floor(-glm::dot(corner, layer.along));
        layer.origin = corner + axes.u * (u * size.x) + axes.v * (v * size.y);
        // Only wood needs the numbers, and takes any.
        constexpr double whole = 0x1p30;
        layer.first_u = static_cast<std::int32_t>(std::fmod(u, whole));
        layer.first_v = static_cast<std::int32_t>(std::fmod(v, whole));
        return layer;
    }

    /// The number of a texture, compiled when a plane first asks for it; -1 after an error.
    int texture_named(const std::string& name) {
        const auto known = std::ranges::find(out_.textures, name, &CompiledTexture::name);
        if (known != out_.textures.end()) return static_cast<int>(known - out_.textures.begin());
        const auto block = std::ranges::find(scene_.textures, name, &TextureBlock::name);
        SizedTexture made = make_texture(*block);
        if (diagnostics_.has_errors()) return -1;
        made.texture.name = name;
        out_.textures.push_back(std::move(made.texture));
        sizes_.push_back(block->size.value_or(made.size));
        if (block->size && out_.textures.back().kind == kernels::TextureKind::wood) {
            out_.textures.back().aspect = block->size->x / block->size->y;
        }
        return static_cast<int>(out_.textures.size()) - 1;
    }

    SizedTexture make_texture(const TextureBlock& block) {
        if (const auto* file = std::get_if<FileTexture>(&*block.source)) return image(block, *file);
        if (const auto* ifs = std::get_if<IfsTexture>(&*block.source))
            return inclusion(block, *ifs);
        return wood(block);
    }

    SizedTexture image(const TextureBlock& block, const FileTexture& file) {
        SizedTexture made;
        made.texture.kind = kernels::TextureKind::image;
        made.texture.color = block.color.value_or(glm::dvec3{1.0});
        const LinearPicture picture = picture_of(block, file);
        made.size = {1, static_cast<double>(picture.height) / picture.width};
        store_levels(make_levels(picture), made.texture, out_.texture_words);
        made.texture.mean *= made.texture.color;
        return made;
    }

    LinearPicture picture_of(const TextureBlock& block, const FileTexture& file) {
        const std::string path = picture_path(scene_, block, file);
        try {
            ImageReader reader(path, kept_image);
            count_picture(reader.header());
            return read_linear_picture(reader);
        } catch (const Error& error) {
            const Position& at = block.source_position;
            const auto number = static_cast<std::size_t>(at.file);
            const std::string scene =
                number < scene_.files.size() ? scene_.files[number].name : std::string();
            throw Error(error.kind(), fmt::format("{}:{}:{}: {}: {}", scene, at.line, at.column,
                                                  block_name("texture", block.name), error.what()));
        }
    }

    /// Holds a scene's pictures to its limits before the next one is unpacked.
    void count_picture(const ImageHeader& header) {
        texels_ += long{header.width} * header.height;
        if (++pictures_ > pictures_a_scene)
            throw Error(ErrorKind::scene,
                        fmt::format("a scene has at most {} pictures", pictures_a_scene));
        if (texels_ > texels_a_scene)
            throw Error(
                ErrorKind::scene,
                fmt::format("the scene's pictures have more than {} pixels", texels_a_scene));
    }

    static SizedTexture wood(const TextureBlock& block) {
        namespace look = kernels::wood;
        SizedTexture made;
        CompiledTexture& texture = made.texture;
        made.size = board_size;
        texture.kind = kernels::TextureKind::wood;
        texture.color = block.color.value_or(light_wood);
        texture.color2 = block.color2.value_or(dark_wood);
        texture.aspect = board_size.x / board_size.y;
        const double open = (1 - look::seam) * (1 - look::seam / texture.aspect);
        texture.mean = (texture.color + look::mean * (texture.color2 - texture.color)) *
                       (1 - look::seam_depth * (1 - open));
        return made;
    }

    SizedTexture inclusion(const TextureBlock& block, const IfsTexture& source) {
        SizedTexture made;
        CompiledTexture& texture = made.texture;
        texture.kind = kernels::TextureKind::inclusion;
        texture.color = block.color.value_or(inlay_color);
        texture.color2 = block.color2.value_or(glm::dvec3{1.0});
        texture.mean = texture.color;
        made.size = compile_flat_ifs(fractals_.at(source.ifs), texture);
        if (!(made.size.x > 0)) {
            diagnostics_.error(block.source_position,
                               fmt::format("{}: ifs \"{}\" is not flat: a map takes z into x or y",
                                           block_name("texture", block.name), source.ifs));
        }
        return made;
    }

    const Scene& scene_;
    const View& view_;
    const std::map<std::string, Fractal>& fractals_;
    CompiledScene& out_;
    Diagnostics& diagnostics_;
    std::vector<glm::dvec2> sizes_;  // of a repeat of each texture, world units
    std::size_t pictures_ = 0;       // that were read
    long texels_ = 0;                // of them
};

}  // namespace

void compile_floor(const Scene& scene, const View& view,
                   const std::map<std::string, Fractal>& fractals, CompiledScene& out,
                   Diagnostics& diagnostics) {
    FloorCompiler(scene, view, fractals, out, diagnostics).run();
}

}  // namespace pxm::host
