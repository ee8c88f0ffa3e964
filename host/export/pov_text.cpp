// A scene for POV-Ray: what stands inside a map at a level is one union of what stands inside its
// maps at the level below, so that the file grows with the levels and not with the cells. Its
// matrices are those of the scene language, and so are its axes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "dsp_kernels/scene_block.hpp"
#include "host/error.hpp"
#include "host/export/writers.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::uint32_t most_levels = 1'000;
constexpr double most_parts = 20'000'000;  // lines of unions

std::string vector_text(const glm::dvec3& v) {
    return fmt::format("<{}, {}, {}>", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

std::string matrix_text(const Affine& m) {
    const glm::dmat3& l = m.linear;
    const glm::dvec3& t = m.translation;
    return fmt::format("matrix <{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}>", l[0].x, l[0].y,
                       l[0].z, l[1].x, l[1].y, l[1].z, l[2].x, l[2].y, l[2].z, t.x, t.y, t.z);
}

std::string pigment_text(const glm::dvec3& color) {
    return fmt::format("pigment {{ color rgb {} }}", vector_text(color));
}

/// The names of a file are those of its objects with a number: none is a word of POV-Ray.
class SystemText {
  public:
    SystemText(const ExportSystem& system, std::size_t number)
        : system_(system), name_(fmt::format("pxm_{}", number)), levels_(levels_of(system)) {
        std::size_t maps = 0;
        for (const SystemSet& set : system.sets) maps += set.maps.size();
        if (static_cast<double>(maps) * levels_ > most_parts)
            throw Error(ErrorKind::setting, fmt::format("object \"{}\": more than {} parts of "
                                                        "unions; fewer --levels",
                                                        printable(system.name), most_parts));
    }

    std::string text() {
        fmt::format_to(std::back_inserter(text_), "// {}: {} levels\n", printable(system_.name),
                       levels_);
        std::vector<std::vector<bool>> used(levels_ + 1,
                                            std::vector<bool>(system_.sets.size(), false));
        used[levels_][static_cast<std::size_t>(system_.start)] = true;
        for (std::uint32_t level = levels_; level > 0; --level)
            for (std::size_t s = 0; s < system_.sets.size(); ++s)
                for (const int m : system_.sets[s].maps)
                    if (used[level][s])
                        used[level - 1][static_cast<std::size_t>(
                            system_.maps[static_cast<std::size_t>(m)].inside)] = true;
        for (std::uint32_t level = 0; level <= levels_; ++level)
            for (std::size_t s = 0; s < system_.sets.size(); ++s)
                if (used[level][s]) put_set(s, level);
        fmt::format_to(std::back_inserter(text_), "object {{ {} {} {} }}\n",
                       set_name(static_cast<std::size_t>(system_.start), levels_),
                       matrix_text(system_.place), pigment_text(system_.color));
        return std::move(text_);
    }

  private:
    /// As many as asked for, or as it takes until every cell is as small.
    static std::uint32_t levels_of(const ExportSystem& system) {
        if (system.maps.empty()) return 0;
        if (system.detail <= 0) return limited(system, system.levels);
        std::vector<double> size;  // a bound of what stands inside after so many maps
        for (const SystemSet& set : system.sets) size.push_back(set.volume.diameter);
        const double outside = lipschitz_constant(system.place);
        const std::uint32_t most = std::min(system.levels, most_levels);
        for (std::uint32_t level = 0; level < most; ++level) {
            if (outside * size[static_cast<std::size_t>(system.start)] <= system.detail)
                return level;
            std::vector<double> larger(size.size(), 0);
            for (std::size_t s = 0; s < size.size(); ++s)
                for (const int m : system.sets[s].maps) {
                    const SystemMap& map = system.maps[static_cast<std::size_t>(m)];
                    larger[s] = std::max(larger[s],
                                         map.stretch * size[static_cast<std::size_t>(map.inside)]);
                }
            size = larger;
        }
        return limited(system, most == most_levels ? most_levels + 1 : most);
    }

    static std::uint32_t limited(const ExportSystem& system, std::uint32_t levels) {
        if (levels <= most_levels) return levels;
        throw Error(ErrorKind::setting, fmt::format("object \"{}\": more than {} levels of unions",
                                                    printable(system.name), most_levels));
    }

    [[nodiscard]] std::string set_name(std::size_t set, std::uint32_t level) const {
        return fmt::format("{}_{}_{}", name_, set + 1, level);
    }

    void put_set(std::size_t s, std::uint32_t level) {
        const SystemSet& set = system_.sets[s];
        const auto out = std::back_inserter(text_);
        fmt::format_to(out, "#declare {} = ", set_name(s, level));
        if (level == 0 || set.maps.empty()) return put_shape(set);
        // A union of one is told as a mistake.
        text_ += set.maps.size() > 1 ? "union {\n" : "object {\n";
        for (const int m : set.maps) {
            const SystemMap& map = system_.maps[static_cast<std::size_t>(m)];
            const std::string inside = set_name(static_cast<std::size_t>(map.inside), level - 1);
            if (set.maps.size() == 1)
                fmt::format_to(out, "    {} {}\n", inside, matrix_text(map.map));
            else
                fmt::format_to(out, "    object {{ {} {} }}\n", inside, matrix_text(map.map));
        }
        text_ += "}\n";
    }

    void put_shape(const SystemSet& set) {
        const auto out = std::back_inserter(text_);
        const CompiledVolume& v = set.volume;
        if (is_volume(set) && v.kind == kernels::Volume::sphere) {
            fmt::format_to(out, "sphere {{ {}, {} }}\n", vector_text(v.center), v.radius);
            return;
        }
        if (is_volume(set) && v.kind == kernels::Volume::box) {
            fmt::format_to(out, "box {{ {}, {} }}\n", vector_text(v.low), vector_text(v.high));
            return;
        }
        fmt::format_to(out, "mesh2 {{\n    vertex_vectors {{ {}", set.shape.vertices.size());
        for (const glm::dvec3& vertex : set.shape.vertices)
            fmt::format_to(out, ", {}", vector_text(vertex));
        const auto triangles = triangles_of(set.shape);
        fmt::format_to(out, " }}\n    face_indices {{ {}", triangles.size());
        for (const auto& [a, b, c] : triangles) fmt::format_to(out, ", <{}, {}, {}>", a, b, c);
        text_ += " }\n}\n";
    }

    /// Whether its shape is the volume's surface.
    static bool is_volume(const SystemSet& set) {
        const Mesh own = mesh_of(set.volume);
        return own.vertices == set.shape.vertices && own.faces == set.shape.faces;
    }

    const ExportSystem& system_;
    std::string name_;
    std::uint32_t levels_;
    std::string text_;
};

std::string camera_text(const ExportScene& scene) {
    const View& view = scene.view;
    const PixelSize size = scene.scene->image.value_or(ImageBlock{}).size.value_or(PixelSize{});
    const double aspect = static_cast<double>(size.rows) / static_cast<double>(size.columns);
    const double width = 2 * view.half_width * (view.orthographic ? scene.scale : 1);
    return fmt::format(
        "camera {{ {} location {} direction {} right {} up {} }}  // {} x {} pixels\n",
        view.orthographic ? "orthographic" : "perspective", vector_text(view.eye * scene.scale),
        vector_text(view.forward), vector_text(view.right * width),
        vector_text(view.up * (width * aspect)), size.columns, size.rows);
}

std::string lights_text(const ExportScene& scene) {
    std::vector<LightBlock> lights = scene.scene->lights;
    if (lights.empty()) lights.emplace_back();
    const double far =
        1000 * (glm::length(scene.view.eye) + scene.view.look_distance) * scene.scale;
    std::string text;
    for (const LightBlock& light : lights) {
        const glm::dvec3 direction = light.direction.value_or(glm::dvec3{0.5, 1, -0.7});
        const glm::dvec3 place =
            light.location ? *light.location * scene.scale : far * glm::normalize(direction);
        text += fmt::format("light_source {{ {}, rgb {}{}{} }}\n", vector_text(place),
                            vector_text(light.color.value_or(glm::dvec3{1.0})),
                            light.location ? "" : " parallel point_at <0, 0, 0>",
                            light.shadow.value_or(false) ? "" : " shadowless");
    }
    return text;
}

}  // namespace

std::string pov_text(const ExportScene& scene, const std::string& title) {
    const RenderBlock render = scene.scene->render.value_or(RenderBlock{});
    std::string text = fmt::format(
        "// {}\n#version 3.7;\nglobal_settings {{ assumed_gamma 1 ambient_light rgb 1 }}\n"
        "background {{ color rgb {} }}\n#default {{ finish {{ ambient rgb {} diffuse 0.8 }} }}\n",
        printable_path(title),
        vector_text(render.background.value_or(glm::dvec3{0.02, 0.02, 0.03})),
        vector_text(render.ambient.value_or(glm::dvec3{0.2})));
    text += camera_text(scene) + lights_text(scene);
    for (std::size_t i = 0; i < scene.systems.size(); ++i)
        text += SystemText(scene.systems[i], i + 1).text();
    return text;
}

}  // namespace pxm::host
