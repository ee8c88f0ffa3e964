// What a search looks for along a ray, and what it asks of the objects it goes through.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/pixel_size.hpp"
#include "dsp_kernels/ray.hpp"
#include "dsp_kernels/scene_block.hpp"

namespace pxm::kernels {

/// A search: a ray, the part of it that counts, the size of a pixel along it, and when to stop.
template <class Real>
struct Search {
    Ray<Real> ray;              // unit direction in the world
    Real start{};               // only cells between start and end are looked for
    Real end = far_away<Real>;  // of that part
    PixelSize<Real> pixel;      // p along the ray
    Real detail;                // a cell is terminal at `detail` pixels: tau_min of local covers
    Real fade;                  // a cell begins to show at `fade` pixels: tau_max of local covers
    std::uint32_t cell_cap;     // most cells tested for one ray
    Method method;              // which search finds the first hit
};

/// Whether the cell's composed linear part is needed for its diameter.
template <NodeLike Node>
[[nodiscard]] bool is_polar(Node& node, std::uint32_t object) noexcept {
    using Object = ObjectRecord<real_words<typename Node::Real>>;
    node.tally(Operation::integer, 1);
    return static_cast<Lipschitz>(node.shape_word(object + Object::lipschitz)) == Lipschitz::polar;
}

/// Whether cells show before they are terminal.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool has_covers(Node& node, const Search<Real>& search) noexcept {
    node.tally(Operation::compare_branch, 1);
    return search.detail < search.fade;
}

/// p at the ray's parameter t, for one object.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real pixel_at(Node& node, const Search<Real>& search, std::uint32_t object,
                            Real t) noexcept {
    using Object = ObjectRecord<real_words<Real>>;
    return pixel_size(node, search.pixel, t, node.shape_real(object + Object::smallest_pixel));
}

}  // namespace pxm::kernels
