// bench_describe SCENE WxH ZOOM: a compiled scene with bounding balls as plain text, for the
// programs that pxm is measured against (bench/described.hpp reads it back).
#include <fmt/format.h>

#include <exception>

#include "host/compile/compile.hpp"
#include "host/error.hpp"
#include "host/render/render.hpp"
#include "host/render/render_options.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"

namespace {

using namespace pxm;
using namespace pxm::host;

std::string text_of(const glm::dvec3& v) { return fmt::format(" {} {} {}", v.x, v.y, v.z); }

std::string text_of(const Affine& map) {
    return text_of(map.linear[0]) + text_of(map.linear[1]) + text_of(map.linear[2]) +
           text_of(map.translation);
}

CompiledScene compiled(const std::string& path, const SceneOverrides& overrides) {
    Diagnostics diagnostics;
    Scene scene = parse_scene(path, diagnostics, {"/"});  // whatever its user measures
    apply(overrides, scene);
    check_scene(scene, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    CompiledScene result = compile(scene, overrides.zoom, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    return result;
}

void print_shape(const CompiledShape& shape) {
    fmt::print("shape {} {} {} {}\n", shape.lipschitz == kernels::Lipschitz::product ? 1 : 0,
               shape.start, shape.maps.size(), shape.sets.size());
    for (const CompiledMap& map : shape.maps) {
        fmt::print("map{} {} {}\n", text_of(map.map), map.constant, map.follow_set);
    }
    for (const CompiledSet& set : shape.sets) {
        fmt::print("set{} {} {} {}", text_of(set.volume.center), set.volume.radius,
                   set.volume.diameter, set.maps.size());
        for (const int map : set.maps) fmt::print(" {}", map);
        fmt::print("\n");
    }
}

void print_scene(const CompiledScene& scene) {
    const CompiledCamera& camera = scene.camera;
    fmt::print("picture {} {} {} {}\n", scene.size.columns, scene.size.rows, scene.unit,
               scene.detail);
    fmt::print("camera {}{}{}{}{} {} {}\n",
               camera.projection == kernels::Projection::orthographic ? 1 : 0,
               text_of(camera.corner), text_of(camera.across), text_of(camera.down),
               text_of(camera.forward), camera.pixel_at_eye, camera.pixel_growth);
    fmt::print("shapes {}\n", scene.shapes.size());
    for (const CompiledShape& shape : scene.shapes) print_shape(shape);
    fmt::print("objects {}\n", scene.objects.size());
    for (const CompiledObject& object : scene.objects) {
        fmt::print("object {}{} {} {} {}\n", object.shape, text_of(object.instance),
                   object.constant, object.diameter, object.levels);
    }
}

}  // namespace

int main(int count, char** values) {
    if (count != 4) {
        fmt::print(stderr, "usage: bench_describe SCENE WxH ZOOM\n");
        return 2;
    }
    try {
        SceneOverrides overrides;
        overrides.size = parse_size(values[2]);
        overrides.zoom = std::stod(values[3]);
        overrides.volume = VolumeKind::sphere;
        print_scene(compiled(values[1], overrides));
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
