#include "host/node_program/link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <optional>
#include <set>

#include "host/error.hpp"
#include "host/node_program/module_table.hpp"
#include "host/node_program/steepness.hpp"
#include "pxm/model.hpp"
#include "pxm/node.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t named_parts = 4;  // of a program that does not fit

bool any_volume(const CompiledScene& scene, kernels::Volume kind) {
    const auto is_kind = [kind](const auto& cell) { return cell.volume.kind == kind; };
    return std::ranges::any_of(scene.enclosures, is_kind) ||
           std::ranges::any_of(scene.shapes, [&](const CompiledShape& shape) {
               return std::ranges::any_of(shape.sets, is_kind);
           });
}

bool any_light(const CompiledScene& scene, kernels::LightKind kind) {
    return std::ranges::any_of(scene.lights,
                               [kind](const CompiledLight& light) { return light.kind == kind; });
}

bool any_texture(const CompiledScene& scene, kernels::TextureKind kind) {
    return std::ranges::any_of(
        scene.textures, [kind](const CompiledTexture& texture) { return texture.kind == kind; });
}

std::int64_t measured_bytes(const std::string& name) {
    const auto found = std::ranges::find(module_table, name, &MeasuredModule::name);
    assert(found != module_table.end());
    return found->bytes();
}

/// Sorts modules into those that a program needs and those that it leaves out, each with its
/// reason.
class ModuleChoice {
  public:
    ModuleChoice(const CompiledScene& scene, NodeProgram& program)
        : scene_(scene), program_(program) {}

    void choose_tracer();
    void choose_search();
    void choose_volumes();
    void choose_floor();
    void choose_light();

  private:
    void take(const char* name, bool needed, const char* why, const char* why_not) {
        (needed ? program_.modules : program_.left_out)
            .push_back({name, needed ? why : why_not, measured_bytes(name)});
    }
    [[nodiscard]] bool has_objects() const { return !scene_.objects.empty(); }
    [[nodiscard]] bool has_surfaces() const { return has_objects() || !scene_.planes.empty(); }
    [[nodiscard]] bool has_covers() const { return needs_covers(scene_) && !scene_.area; }

    const CompiledScene& scene_;
    NodeProgram& program_;
};

void ModuleChoice::choose_tracer() {
    const bool plain = needs_plain_features(scene_), area = scene_.area, covers = has_covers();
    take("pixel_program", true, "every node has pixels", "");
    take("trace", plain, "the first cell of each eye ray is all that counts",
         "another tracer takes its place");
    take("trace_rays", !plain && !covers && !area, "shadows or mirrors, and no local covers",
         plain ? "no shadows and mirrors" : "another tracer takes its place");
    take("trace_all", covers, "local covers or translucent objects",
         area ? "covers: area" : "covers: off, and no translucent object");
    take("trace_area", area, "covers: area", "no covers: area");
    take("beam", area, "covers: area", "no covers: area");
}

void ModuleChoice::choose_search() {
    const bool objects = has_objects();
    const bool perspective = scene_.camera.projection == kernels::Projection::perspective;
    take("vectors", true, "every other module calls it", "");
    take("camera", true, "every pixel has an eye ray", "");
    take("perspective", perspective, "a perspective camera", "an orthographic camera");
    take("orthographic", !perspective, "an orthographic camera", "a perspective camera");
    take("intersect", true, "every ray looks for a cell", "");
    take("heap", true, "where intersect keeps cells", "");
    take("intersect_fast", scene_.method == kernels::Method::fast, "intersect: fast",
         "intersect: heap");
    take("descend", objects, "ifs objects", "no objects");
    take("next_after", objects, "a heap may overflow", "no objects");
}

void ModuleChoice::choose_volumes() {
    const bool polar = std::ranges::any_of(scene_.shapes, [](const CompiledShape& shape) {
        return shape.lipschitz == kernels::Lipschitz::polar;
    });
    const bool lifted = std::ranges::any_of(scene_.shapes, &CompiledShape::lifted);
    const bool steep = std::ranges::count(steep_shapes(scene_), true) > 0;
    take("sphere", any_volume(scene_, kernels::Volume::sphere), "bounding spheres",
         "no bounding sphere");
    take("box", any_volume(scene_, kernels::Volume::box), "bounding boxes", "no bounding box");
    take("oriented", any_volume(scene_, kernels::Volume::oriented),
         "bounding boxes in axes of their own", "no box in axes of its own");
    take("hull", any_volume(scene_, kernels::Volume::hull), "bounding hulls", "no bounding hull");
    take("cone", any_volume(scene_, kernels::Volume::cone), "cones", "no cone");
    take("cylinder", any_volume(scene_, kernels::Volume::cylinder), "cylinders", "no cylinder");
    take("polar", polar, "maps that are no similitudes, or lipschitz: polar",
         "Lipschitz constants by product or determinant");
    take("flatness", lifted, "lifted singular maps", "no singular map");
    take("steepness", steep, "maps that squash very much", "no map squashes very much");
}

void ModuleChoice::choose_floor() {
    take("shade", has_objects(), "objects are shaded", "no objects");
    take("plane", !scene_.planes.empty(), "planes", "no planes");
    take("texture", !scene_.textures.empty(), "planes have textures", "no textures");
    take("texture_image", any_texture(scene_, kernels::TextureKind::image), "textures from files",
         "no texture from a file");
    take("texture_wood", any_texture(scene_, kernels::TextureKind::wood), "wooden textures",
         "no wooden texture");
    take("texture_inclusion", any_texture(scene_, kernels::TextureKind::inclusion),
         "flat attractors as textures", "no texture is an ifs");
}

void ModuleChoice::choose_light() {
    const bool surfaces = has_surfaces(), shadows = surfaces && needs_shadows(scene_);
    const bool area = scene_.area, covers = has_covers();
    const char* nothing = "no objects or planes";
    take("illuminate", surfaces, "surfaces are lit", nothing);
    take("covers", covers, "local covers or translucent objects",
         area ? "covers: area" : "covers: off, and no translucent object");
    take("shadow", shadows, "lights that cast shadows", "no light casts shadows");
    take("shadow_point",
         shadows && std::ranges::any_of(scene_.lights,
                                        [](const CompiledLight& light) {
                                            return light.shadow &&
                                                   light.kind == kernels::LightKind::point;
                                        }),
         "point lights that cast shadows", "no point light casts shadows");
    take("mirror", needs_mirrors(scene_), "surfaces that reflect", "no surface reflects");
    take("point_light", surfaces && any_light(scene_, kernels::LightKind::point), "point lights",
         surfaces ? "directional lights only" : nothing);
}

void choose_modules(const CompiledScene& scene, NodeProgram& program) {
    ModuleChoice choice(scene, program);
    choice.choose_tracer();
    choice.choose_search();
    choice.choose_volumes();
    choice.choose_floor();
    choice.choose_light();
}

/// The deepest chain of calls from a function on, through modules that are in.
class Stack {
  public:
    explicit Stack(const NodeProgram& program) : depth_(function_table.size()) {
        for (const ProgramModule& module : program.modules) linked_.insert(module.name);
    }

    [[nodiscard]] std::int64_t depth(std::size_t function) {
        if (!depth_[function]) {
            const MeasuredFunction& measured = function_table[function];
            const auto below = deepest_callee(measured);
            depth_[function] = measured.stack_bytes + (below ? depth(*below) : 0);
        }
        return *depth_[function];
    }
    [[nodiscard]] std::vector<std::string> chain(std::size_t function) {
        std::vector<std::string> names;
        for (std::optional at = function; at; at = deepest_callee(function_table[*at])) {
            names.emplace_back(function_table[*at].name);
        }
        return names;
    }

  private:
    std::optional<std::size_t> deepest_callee(const MeasuredFunction& caller) {
        std::optional<std::size_t> deepest;
        for (const std::size_t callee : caller.calls) {
            if (!linked_.contains(function_table[callee].module)) continue;
            if (!deepest || depth(*deepest) < depth(callee)) deepest = callee;
        }
        return deepest;
    }

    std::set<std::string_view> linked_;
    std::vector<std::optional<std::int64_t>> depth_;
};

}  // namespace

std::int64_t NodeProgram::modules_bytes() const {
    std::int64_t sum = 0;
    for (const ProgramModule& module : modules) sum += module.bytes;
    return sum;
}

std::int64_t NodeProgram::used_bytes() const {
    return modules_bytes() + heap_order_bytes + stack_bytes;
}

NodeProgram link(const CompiledScene& scene) {
    NodeProgram program;
    choose_modules(scene, program);
    const std::string_view tracer = scene.area                    ? "trace_area"
                                    : needs_plain_features(scene) ? "trace"
                                    : needs_covers(scene)         ? "trace_all"
                                                                  : "trace_rays";
    const auto entry = std::ranges::find_if(function_table, [&](const MeasuredFunction& function) {
        return function.module == tracer && function.name == entry_function;
    });
    const auto start = static_cast<std::size_t>(entry - function_table.begin());
    Stack stack(program);
    program.stack_bytes = stack.depth(start);
    program.deepest_calls = stack.chain(start);
    program.heap_order_bytes = heap_order_bytes(scene.heap);
    return program;
}

void require_fit(const NodeProgram& program, const std::string& model) {
    if (program.used_bytes() <= fast_memory_bytes) return;
    std::vector<std::pair<std::int64_t, std::string>> parts;
    parts.emplace_back(program.heap_order_bytes, "the heap's order");
    parts.emplace_back(program.stack_bytes, "the stack");
    for (const ProgramModule& module : program.modules) {
        parts.emplace_back(module.bytes, fmt::format("module \"{}\"", module.name));
    }
    std::ranges::stable_sort(parts, std::ranges::greater{}, &decltype(parts)::value_type::first);
    std::string text = fmt::format(
        "the node program does not fit the fast memory of the {}: {} bytes wanted, {} there\n"
        "its largest parts: ",
        model, program.used_bytes(), fast_memory_bytes);
    for (std::size_t i = 0; i < named_parts; ++i) {
        text += fmt::format("{}{} {} bytes", i == 0 ? "" : ", ", parts[i].second, parts[i].first);
    }
    throw Error(ErrorKind::machine_limit, text);
}

}  // namespace pxm::host
