// The camera of a scene with its defaults filled in: where a page that moves it begins.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// A system as the engines see it: its maps by what may stand inside them (Ch. 4), each such set
/// within its bounds.
struct SystemView {
    std::vector<FollowSet> sets;
    std::vector<Bounds> bounds;  // of each set
    std::vector<int> follow_of;  // per map: the set of what may stand inside it
    int start = 0;
};

struct SceneView {
    std::array<std::string, 3> eye;  // before `zoom`
    std::array<std::string, 3> look;
    glm::dvec3 up{0, 1, 0};
    double half_width = 1;  // tan(fov / 2)
    std::optional<double> orthographic;
    double zoom = 1;
    Ball ball;                               // around all objects
    std::map<std::string, Ball> attractors;  // of the systems that are shown, in their coordinates
    std::map<std::string, SystemView> systems;  // the same systems
};

/// As compile() sees the scene, at that size. Systems that do not contract are added to
/// `diagnostics`. Precondition: check_scene found the scene right.
[[nodiscard]] SceneView view_of(const Scene& scene, const PixelSize& size,
                                Diagnostics& diagnostics);

}  // namespace pxm::host
