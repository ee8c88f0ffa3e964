// Commands to a map: each post-multiplies the current matrix (App. B).
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "host/scene/scene.hpp"

namespace pxm::host {
namespace {

/// Sec. 9.3: the affine map with from[i] -> to[i]. With edges e_i = from[i] - from[0] and their
/// images f_i, T = sum over i of (e_j x e_k) f_i / det: one division, so that exact corners stay
/// exact.
Affine tetrahedron_map(const TetrahedronCommand& command) {
    constexpr double flat = 1e-12;  // of the volume that edges of these lengths could span
    const auto& p = command.from;
    const auto& q = command.to;
    const glm::dvec3 e1 = p[1] - p[0];
    const glm::dvec3 e2 = p[2] - p[0];
    const glm::dvec3 e3 = p[3] - p[0];
    const glm::dvec3 c1 = glm::cross(e2, e3);
    const glm::dvec3 c2 = glm::cross(e3, e1);
    const glm::dvec3 c3 = glm::cross(e1, e2);
    const double volume = glm::dot(e1, c1);
    if (!(std::abs(volume) > flat * glm::length(e1) * glm::length(e2) * glm::length(e3)))
        throw std::domain_error("the four points of the tetrahedron lie in a plane");
    Affine map;
    for (int axis = 0; axis < 3; ++axis)
        map.linear[axis] =
            (c1[axis] * (q[1] - q[0]) + c2[axis] * (q[2] - q[0]) + c3[axis] * (q[3] - q[0])) /
            volume;
    map.translation = q[0] - map.linear * p[0];
    return map;
}

struct MapOf {
    Affine operator()(const ScaleCommand& command) const { return scaling(command.factors); }
    Affine operator()(const RotateCommand& command) const {
        return rotation(command.axis, command.degrees);
    }
    Affine operator()(const TranslateCommand& command) const { return translation(command.offset); }
    Affine operator()(const MatrixCommand& command) const { return command.map; }
    Affine operator()(const TetrahedronCommand& command) const { return tetrahedron_map(command); }
    Affine operator()(const BlendCommand&) const {
        throw std::domain_error("a blend is of maps of a scene's text");
    }
};

}  // namespace

Affine compose(const std::vector<Command>& commands) {
    Affine map;
    for (const Command& command : commands) map = then(map, std::visit(MapOf{}, command.kind));
    return map;
}

}  // namespace pxm::host
