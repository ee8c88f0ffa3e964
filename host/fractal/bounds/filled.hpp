// Attractors that fill what bounds them: solids with flat faces, convex polygons, and smooth
// surfaces over convex polygons. The hull of such a set is the set itself, or nearly so in small
// cells, and the faces of hulls are turned as the attractor is; of other volumes they are not.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "host/fractal/bounds/convex_hull.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

enum class Filling {
    none,
    solid,    // every set is its convex hull
    polygon,  // every set is a convex polygon in a plane
    surface   // along one direction every set is seen as a convex polygon, and in that direction
              // the maps make it ever flatter
};

/// What the sets of a system fill, one hull a set. Of polygons and of what surfaces are seen as it
/// is the hull of the polygon moved to both sides by a quarter of its size.
struct Filled {
    Filling filling = Filling::none;
    std::vector<ConvexHull> hulls;
    std::vector<glm::dvec3> across;  // a unit vector: the normal of each polygon's plane, or the
                                     // direction that a surface is seen along
};

/// That every hull holds the images of those that may stand in it is shown up to rounding; that
/// these leave nothing free is tried with two thousand points a set. Costs little where the maps'
/// determinants forbid it. Precondition: the system contracts.
[[nodiscard]] Filled find_filling(const Rifs& rifs);

}  // namespace pxm::host
