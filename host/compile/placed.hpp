// An object of a scene on its way to the nodes: where it is in the world.
#pragma once

#include <vector>

#include "host/compile/lifted_fractal.hpp"
#include "host/math/affine.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// An object: its block, its fractal (none if a volume is the object), its place in the world.
struct Placed {
    const ObjectBlock* block;
    Fractal* fractal;
    Affine instance;  // ifs coordinates to world

    [[nodiscard]] Ball own_ball() const;
    [[nodiscard]] Ball world_ball() const;
};

/// A ball around all objects; the unit ball if there are none.
[[nodiscard]] Ball ball_around(const std::vector<Placed>& objects);

}  // namespace pxm::host
