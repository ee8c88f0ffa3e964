// Whether the cells of a shape overlap so much that a ray must remember which it has opened
// (docs/overlaps.md), and what native nodes need for that.
#pragma once

#include <algorithm>
#include <span>
#include <type_traits>

#include "host/compiled/compiled_scene.hpp"
#include "host/node_program/native_node.hpp"

namespace pxm::host {

/// Whether words by the thousand lead to cells around some points of the attractor, and four or
/// more of them to (nearly) the same cell. Looks at cells down to 1/256 of the outermost one.
/// No, if maps were lifted. Takes some time: compile() asks once and keeps it with the shape.
[[nodiscard]] bool is_crowded(const CompiledShape& shape);

/// Whether an object of the scene has such a shape, by what compile() found.
[[nodiscard]] bool has_crowded_objects(const CompiledScene& scene);

/// The share of a pixel by which a ray tells the cells of crowded objects from those that it has
/// opened, 0 where there are none: half a pixel; less where maps shrink by less than a tenth, for
/// what is left out for another cell shifts the picture, and of such cells very many stand inside
/// each other before they are as small as a pixel.
[[nodiscard]] double known_share(const CompiledScene& scene);

/// Entries of the heap where cells are crowded. A larger heap changes no picture
/// (dsp_kernels/heap.hpp).
inline constexpr long crowded_heap = 1 << 16;

/// A native node for a scene whose cells are opened by searches. In dsp32 it is what it is on the
/// machine: native dsp32 is there to show what the machine shows.
template <class Node>
[[nodiscard]] Node make_native_node(const CompiledScene& scene,
                                    std::span<const std::uint32_t> block) {
    using Real = typename Node::Real;
    const double share = std::is_same_v<Real, dsp32::Float> ? 0 : known_share(scene);
    const long heap = share > 0 ? std::max(scene.heap, crowded_heap) : scene.heap;
    return Node(block, scene.texture_words, heap, sizeof(kernels::Cell<Real>), share);
}

}  // namespace pxm::host
