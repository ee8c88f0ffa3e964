// The cells around an object that was once a cell itself (host/compile/reroot): the normals where a
// ray enters them. As walk_enclosing() of dsp_kernels/shade.hpp.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/wide/packet/ray_packet.hpp"
#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

struct EnclosingNormal {
    glm::vec3 normal;  // in the packet's frame
    double depth;      // where the ray enters the cell
    float diameter;    // of the cell
};

/// Those of the cells around `object` that a ray of the packet enters, in `found`.
void find_enclosing(const WideScene& scene, const WideObject& object, const RayPacket& packet,
                    int ray, std::vector<EnclosingNormal>& found);

}  // namespace pxm::host::wide
