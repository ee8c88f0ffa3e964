// What a node program may ask of the node it runs on. pxm::Node has the limits, faults and counts
// of the machine; host::NativeNode has none, and its tallies compile to nothing.
#pragma once

#include <concepts>
#include <cstdint>

#include "pxm/tally.hpp"

namespace pxm {

template <class N>
concept NodeLike = requires(N node, std::uint32_t address, Operation operation) {
    typename N::Real;
    /// A word, or a number, of the shape database in the back frame buffer, by word address.
    { node.shape_word(address) }
    noexcept->std::same_as<std::uint32_t>;
    { node.shape_real(address) }
    noexcept->std::same_as<typename N::Real>;
    /// A word of the texture memory, by word address.
    { node.texture_word(address) }
    noexcept->std::same_as<std::uint32_t>;
    /// Entries of the heap, in z-buffer memory, and their order, in fast memory.
    { node.template heap_records<std::uint32_t>() }
    noexcept->std::same_as<std::uint32_t*>;
    { node.heap_order() }
    noexcept->std::same_as<std::uint32_t*>;
    { node.heap_capacity() }
    noexcept->std::same_as<int>;
    /// Counts operations of a kind.
    { node.tally(operation, 1U) }
    noexcept;
};

}  // namespace pxm
