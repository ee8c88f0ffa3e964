// The distributed frame buffer: every columns-th pixel in x and rows-th pixel in y belongs to one
// node.
#pragma once

#include <cstdint>

#include "pxm/model.hpp"
#include "pxm/node.hpp"

namespace pxm {

/// The node that owns pixel (x, y).
[[nodiscard]] constexpr NodeId owner(const Model& model, int x, int y) noexcept {
    return {x % model.columns, y % model.rows};
}

/// How many of the pixels 0 .. size-1 along one axis belong to place `first` of `stride`.
[[nodiscard]] constexpr int owned_along(int size, int first, int stride) noexcept {
    return size > first ? (size - first - 1) / stride + 1 : 0;
}

/// Pixels of a width x height raster that the node owns.
[[nodiscard]] constexpr std::int64_t owned_pixels(const Model& model, NodeId id, int width,
                                                  int height) noexcept {
    return std::int64_t{owned_along(width, id.column, model.columns)} *
           owned_along(height, id.row, model.rows);
}

/// The place of pixel (x, y) in its owner's front buffer, counted row by row.
[[nodiscard]] constexpr std::uint32_t pixel_in_node(const Model& model, int width, int x,
                                                    int y) noexcept {
    const int per_row = owned_along(width, x % model.columns, model.columns);
    return static_cast<std::uint32_t>((y / model.rows) * per_row + x / model.columns);
}

}  // namespace pxm
