// A picture as a texture: four texels of the two sizes next to the spot's, mixed (trilinear). All
// sizes lie in the texture memory of a node (Ch. 19), made by the host (host/compile/image_levels).
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/floor_block.hpp"
#include "dsp_kernels/footprint.hpp"

namespace pxm::kernels {

/// A texel, squared but not yet scaled.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> texel(Node& node, std::uint32_t address) noexcept {
    const std::uint32_t word = node.texture_word(address);
    node.tally(Operation::integer, 5);
    node.tally(Operation::to_float, 3);
    node.tally(Operation::multiply_add, 3);
    const auto root = [](std::uint32_t bits) {
        return from_double<Real>(static_cast<int>(bits & 0x3FF));
    };
    const Vec3<Real> roots{root(word >> 20), root(word >> 10), root(word)};
    return {roots.x * roots.x, roots.y * roots.y, roots.z * roots.z};
}

/// (1 - share) a + share b.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> mix(Node& node, const Vec3<Real>& a, const Vec3<Real>& b,
                             Real share) noexcept {
    return add_scaled(node, a, share, subtract(node, b, a));
}

/// Two neighbouring texels along an axis that goes round, and the share of the second.
template <class Real>
struct Neighbours {
    std::uint32_t first;   // its number from 0
    std::uint32_t second;  // that of the next one
    Real share;            // of the second, 0 to 1
};

/// The texels whose centres are about the place `fraction` of `count` texels.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Neighbours<Real> neighbours(Node& node, Real fraction, std::uint32_t count) noexcept {
    constexpr Real half = from_double<Real>(0.5);
    node.tally(Operation::to_float, 2);
    node.tally(Operation::multiply_add, 2);
    node.tally(Operation::integer, 4);
    const auto texels = static_cast<int>(count);
    const Real x = fraction * from_double<Real>(texels) - half;
    const int below = floor_integer(x);
    const int first = below < 0 ? below + texels : below;
    const int second = below + 1 < texels ? below + 1 : 0;
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second),
            x - from_double<Real>(below)};
}

/// A level of an image at a place from (0, 0), bottom left, to (1, 1).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> image_level(Node& node, std::uint32_t level, Real u, Real v) noexcept {
    using Level = ImageLevelRecord<real_words<Real>>;
    node.tally(Operation::multiply_add, 1);
    node.tally(Operation::integer, 6);
    const std::uint32_t width = node.shape_word(level + Level::width);
    const std::uint32_t height = node.shape_word(level + Level::height);
    const std::uint32_t texels = node.shape_word(level + Level::texels);
    const Neighbours<Real> x = neighbours(node, u, width);
    const Neighbours<Real> y = neighbours(node, Real(1) - v, height);  // the first row is on top
    const std::uint32_t upper = texels + y.first * width;
    const std::uint32_t lower = texels + y.second * width;
    return mix(
        node, mix(node, texel(node, upper + x.first), texel(node, upper + x.second), x.share),
        mix(node, texel(node, lower + x.first), texel(node, lower + x.second), x.share), y.share);
}

/// The width of a spot in texels of an image's finest level: the longer of its axes.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real width_in_texels(Node& node, std::uint32_t finest,
                                   const Spot<Real>& spot) noexcept {
    using Level = ImageLevelRecord<real_words<Real>>;
    node.tally(Operation::to_float, 2);
    node.tally(Operation::multiply_add, 8);
    node.tally(Operation::select, 1);
    node.tally(Operation::square_root, 1);
    const Real width = from_double<Real>(static_cast<int>(node.shape_word(finest + Level::width)));
    const Real height =
        from_double<Real>(static_cast<int>(node.shape_word(finest + Level::height)));
    const auto square = [&](const Vec2<Real>& axis) {
        const Real across = axis.u * width;
        const Real down = axis.v * height;
        return across * across + down * down;
    };
    const Real minor = square(spot.minor);
    const Real major = square(spot.major);
    return square_root(minor < major ? major : minor);
}

/// The colour of an image within a spot. Each level has texels twice as wide as the one before.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> image_color(Node& node, std::uint32_t texture,
                                     const Spot<Real>& spot) noexcept {
    using Texture = TextureRecord<real_words<Real>>;
    using Level = ImageLevelRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    std::uint32_t level = node.shape_word(texture + Texture::levels);
    Real width = width_in_texels(node, level, spot);
    std::uint32_t coarser = node.shape_word(texture + Texture::level_count) - 1;
    for (; coarser > 0 && Real(2) < width; --coarser) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::compare_branch, 1);
        node.tally(Operation::multiply_add, 1);
        width = width * from_double<Real>(0.5);
        level += Level::words;
    }
    const Real u = place_of(node, spot.at.u).fraction;
    const Real v = place_of(node, spot.at.v).fraction;
    Vec3<Real> color = image_level(node, level, u, v);
    node.tally(Operation::compare_branch, 1);
    if (coarser > 0 && Real(1) < width) {
        node.tally(Operation::multiply_add, 1);
        color = mix(node, color, image_level(node, level + Level::words, u, v), width - Real(1));
    }
    return scale(node, node.shape_real(texture + Texture::unit), color);
}

}  // namespace pxm::kernels
