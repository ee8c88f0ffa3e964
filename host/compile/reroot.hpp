// Deep zooms: where the eye is so near an object that a pixel there is lost in the digits of a
// node's numbers, the object is replaced by its cells. The largest ones that keep their distance
// become objects of their own, their maps composed here with 77 digits. What a node computes with
// is never much larger than what it looks at.
#pragma once

#include <vector>

#include "host/compile/enclosure.hpp"
#include "host/compile/shape.hpp"
#include "host/compile/view.hpp"
#include "host/compiled/compiled_scene.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// What an object of the compiled scene was made from.
struct Root {
    const Rifs* rifs = nullptr;  // null: it stays as it is
    ShapeFrame frame;            // of its shape
    Affine instance;             // ifs coordinates to world
};

/// Replaces what is too near the eye of a perspective camera; all else stays as it is. If
/// anything was replaced, the scene has another unit. One root for each object, in their order.
/// Needs everything in the scene that rays from the eye need, except lights and planes.
void reroot(const std::vector<Root>& roots, const View& view, Rays rays, CompiledScene& scene);

}  // namespace pxm::host
