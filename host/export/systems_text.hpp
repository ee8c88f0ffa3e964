// The systems of a scene, object by object, for files that hold systems and no cells.
#pragma once

#include <string>
#include <vector>

#include "host/compile/proven_rifs.hpp"
#include "host/math/affine.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

struct SystemOfObject {
    ObjectBlock object;
    const IfsBlock* block = nullptr;
    Rifs rifs;
    Affine place;
    std::vector<double> weights;  // as written, else those that spread points evenly
};

/// Every object that is a fractal; of the others it says, in `messages`, that they are left out.
/// Throws Error(ErrorKind::scene) if there is none, or one is wrong.
[[nodiscard]] std::vector<SystemOfObject> systems_of(const Scene& scene, std::string& messages);

/// Whether the map keeps the plane z = 0 and neither takes z into x or y.
[[nodiscard]] bool is_of_plane(const Affine& map);

/// Whether the camera looks at the plane z = 0 from the front, upright, in parallel rays, as it
/// does in scenes that were imported from the plane.
[[nodiscard]] bool faces_plane(const CameraBlock& camera);

}  // namespace pxm::host
