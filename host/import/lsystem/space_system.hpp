// L-systems of a turtle in space, with brackets (Prusinkiewicz and Lindenmayer's, [ABOP]), and the
// recurrent IFS of their limit: as lsystem.hpp has it for the plane.
#pragma once

#include <string>
#include <vector>

#include "host/import/lsystem/lsystem.hpp"
#include "host/math/affine.hpp"

namespace pxm::host {

/// A map of the system: the place of a symbol in a rule. Inside it come the maps of `inside`.
struct SpaceMap {
    Affine map;  // a similarity
    int inside = 0;
};
struct SpaceKind {
    std::string name;
    std::vector<SpaceMap> maps;
};
/// E_kind = union of map(E_inside) over the kind's maps; the picture is that of `start`. In the
/// scene's space: the turtle begins upward, its left is the picture's, what is above it comes
/// towards the viewer. The first edge is 1 long.
struct SpaceSystem {
    std::vector<SpaceKind> kinds;
    std::vector<SpaceMap> start;
    double growth = 1;
};

/// The system of the limit. Throws Error(ErrorKind::scene) with the reason if there is no exact
/// one.
[[nodiscard]] SpaceSystem space_system(const Lsystem& lsystem);

/// The system as a block without a name.
[[nodiscard]] IfsBlock space_maps(const SpaceSystem& system);

}  // namespace pxm::host
