// Bounding volumes: where a ray enters and leaves them, and their normals there (Sec. 12.2).
// Volumes stay where they are; it is the ray that was transformed (Sec. 12.5). Each kind is a
// module of its own, which the linker leaves out where no volume of the scene is of that kind. Node
// code: no allocation, no exceptions.
#pragma once

#include <optional>

#include "dsp_kernels/volume_box.hpp"
#include "dsp_kernels/volume_cone.hpp"
#include "dsp_kernels/volume_cylinder.hpp"
#include "dsp_kernels/volume_hull.hpp"
#include "dsp_kernels/volume_oriented.hpp"
#include "dsp_kernels/volume_sphere.hpp"

namespace pxm::kernels {

/// The part of the whole line that lies in the volume of a follow set; t as along the world's ray.
/// Precondition: the ray was re-based to the volume's centre.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] std::optional<Interval<Real>> intersect_volume(Node& node, const Ray<Real>& ray,
                                                             std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::integer, 1);
    switch (static_cast<Volume>(node.shape_word(follow_set + FollowSet::volume))) {
        case Volume::sphere:
            return intersect_sphere(node, ray, follow_set);
        case Volume::box:
            return intersect_box(node, ray, follow_set);
        case Volume::oriented:
            return intersect_oriented(node, ray, follow_set);
        case Volume::hull:
            return intersect_hull(node, ray, follow_set);
        case Volume::cone:
            return intersect_cone(node, ray, follow_set);
        case Volume::cylinder:
            return intersect_cylinder(node, ray, follow_set);
    }
    return {};
}

/// The outward normal of a follow set's volume at one end of its interval on the ray (t is that
/// end), of any length, in the volume's coordinates.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> volume_normal(Node& node, const Ray<Real>& ray, Real t, Side side,
                                       std::uint32_t follow_set) noexcept {
    using FollowSet = FollowSetRecord<real_words<Real>>;
    node.tally(Operation::integer, 1);
    switch (static_cast<Volume>(node.shape_word(follow_set + FollowSet::volume))) {
        case Volume::sphere:
            return sphere_normal(node, ray, t, follow_set);
        case Volume::box:
            return box_normal(node, ray, side, follow_set);
        case Volume::oriented:
            return oriented_normal(node, ray, side, follow_set);
        case Volume::hull:
            return hull_normal(node, ray, side, follow_set);
        case Volume::cone:
            return cone_normal(node, ray, side, follow_set);
        case Volume::cylinder:
            return cylinder_normal(node, ray, side, follow_set);
    }
    return {};
}

}  // namespace pxm::kernels
