// Systems as AIFS, the language of IFStile: a block an object, in it a set a follow set, each the
// union of its maps' images. IFStile's space is right-handed with z up: y and z change places.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/export/systems_text.hpp"
#include "host/export/writers.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {
namespace {

/// What a reader of the plane makes of z: the root of the area's growth, or the largest stretch, so
/// that the plane's two dimensions say all of the map.
bool is_plane_map(const Affine& map) {
    if (!is_of_plane(map)) return false;
    Affine flat = map;
    flat.linear[2][2] = 0;
    const double area =
        std::abs(flat.linear[0][0] * flat.linear[1][1] - flat.linear[1][0] * flat.linear[0][1]);
    constexpr double point_thickness = 0.5;  // host/import/plane_map.cpp
    const double stretch = lipschitz_constant(flat);
    const double z = area > 0 ? std::sqrt(area) : stretch > 0 ? stretch : point_thickness;
    return map.linear[2][2] == z;
}

std::string plane_text(const Affine& map) {
    const glm::dmat3& m = map.linear;
    return fmt::format("[{}, {}]*[{}, {}, {}, {}]", map.translation.x, map.translation.y, m[0].x,
                       m[1].x, m[0].y, m[1].y);
}

std::string space_text(const Affine& map) {
    const glm::dmat3& m = map.linear;
    const glm::dvec3& t = map.translation;
    return fmt::format("[{}, {}, {}]*[{}, {}, {}, {}, {}, {}, {}, {}, {}]", t.x, t.z, t.y, m[0].x,
                       m[2].x, m[1].x, m[0].z, m[2].z, m[1].z, m[0].y, m[2].y, m[1].y);
}

/// Of a scene that says where its eye is: place, target, up, and the angle of view.
std::string camera_text(const Scene& scene) {
    if (!scene.camera || !scene.camera->eye || !scene.camera->look) return "";
    const CameraBlock& camera = *scene.camera;
    if (camera.orthographic || camera.zoom) return "";
    const DecimalVec3& eye = *camera.eye;
    const DecimalVec3& look = *camera.look;
    const glm::dvec3 up = camera.up.value_or(glm::dvec3{0, 1, 0});
    constexpr double default_fov_degrees = 40;  // docs/scene-language.md
    return fmt::format("$camera=[{}, {}, {}, {}, {}, {}, {}, {}, {}, {}]\n", eye[0].value,
                       eye[2].value, eye[1].value, look[0].value, look[2].value, look[1].value,
                       up.x, up.z, up.y, camera.fov.value_or(default_fov_degrees));
}

std::string block_text(const SystemOfObject& system, const Scene& scene) {
    std::vector<Affine> maps = system.rifs.maps;
    if (!(system.place == Affine{}))
        for (Affine& map : maps) map = then(then(inverse(system.place), map), system.place);
    // What is of two dimensions is seen from the front when it comes back.
    const bool plane = faces_plane(scene.camera.value_or(CameraBlock{})) &&
                       std::ranges::all_of(maps, is_plane_map);
    std::string text = fmt::format("@\n$dim={}\n$n={}\n$root=S{}\n", plane ? 2 : 3,
                                   system.object.name, system.rifs.start + 1);
    if (!plane) text += camera_text(scene);
    for (std::size_t s = 0; s < system.rifs.follow_sets.size(); ++s) {
        text += fmt::format("S{}=", s + 1);
        const char* between = "";
        for (const int m : system.rifs.follow_sets[s].maps) {
            const Affine& map = maps[static_cast<std::size_t>(m)];
            text += fmt::format("{}{}*S{}", between, plane ? plane_text(map) : space_text(map),
                                system.rifs.follow_of[static_cast<std::size_t>(m)] + 1);
            between = " |\n    ";
        }
        text += '\n';
    }
    return text;
}

}  // namespace

std::string aifs_text(const Scene& scene, std::string& messages) {
    std::string text;
    bool colored = false;
    for (const SystemOfObject& system : systems_of(scene, messages)) {
        text += block_text(system, scene);
        colored = colored || std::ranges::any_of(system.block->maps, [](const MapBlock& map) {
                      return map.color || map.weight;
                  });
    }
    if (colored) messages += "AIFS has no colours and no weights of maps: left out\n";
    return text;
}

}  // namespace pxm::host
