// The textures that lie on a plane. Each is looked at in several spots along the footprint of a
// pixel, and its colour is their mean; the colours of layers multiply.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/texture_image.hpp"
#include "dsp_kernels/texture_inclusion.hpp"
#include "dsp_kernels/texture_wood.hpp"

namespace pxm::kernels {

/// Whether a spot is so far off or so wide that only a texture's mean is left of it.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool is_beyond(Node& node, const Spot<Real>& spot) noexcept {
    constexpr Real limit = from_double<Real>(farthest_repeat);
    node.tally(Operation::select, 6);
    node.tally(Operation::compare_branch, 6);
    const auto within = [&](const Vec2<Real>& x) {
        return absolute(x.u) < limit && absolute(x.v) < limit;
    };
    return !(within(spot.at) && within(spot.minor) && within(spot.major));
}

/// The colour of a layer's texture within a spot.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> texture_color(Node& node, std::uint32_t layer,
                                       const Spot<Real>& spot) noexcept {
    using Layer = LayerRecord<real_words<Real>>;
    using Texture = TextureRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    node.tally(Operation::integer, 2);
    const std::uint32_t texture = node.shape_word(layer + Layer::texture);
    if (is_beyond(node, spot)) return read_vector(node, texture + Texture::mean);
    switch (static_cast<TextureKind>(node.shape_word(texture + Texture::kind))) {
        case TextureKind::image:
            return image_color(node, texture, spot);
        case TextureKind::wood:
            return wood_color(node, texture, node.shape_word(layer + Layer::first_u),
                              node.shape_word(layer + Layer::first_v), spot);
        case TextureKind::inclusion:
            return inclusion_color(node, texture, spot);
    }
    return {};
}

/// The colour of a layer within the footprint of a pixel about a point of its plane.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> layer_color(Node& node, std::uint32_t layer, const Vec3<Real>& point,
                                     const Footprint<Real>& foot) noexcept {
    using Layer = LayerRecord<real_words<Real>>;
    node.tally(Operation::call, 1);
    const Vec3<Real> across = read_vector(node, layer + Layer::across);
    const Vec3<Real> along = read_vector(node, layer + Layer::along);
    const Vec3<Real> from_origin = subtract(node, point, read_vector(node, layer + Layer::origin));
    const Vec2<Real> center = in_repeats(node, from_origin, across, along);
    const Vec2<Real> major = in_repeats(node, foot.major, across, along);
    Spot<Real> spot;
    spot.minor = in_repeats(node, foot.minor, across, along);
    node.tally(Operation::reciprocal, 1);
    node.tally(Operation::to_float, 1);
    node.tally(Operation::multiply_add, 2);
    const Real share = reciprocal(from_double<Real>(foot.spots));
    spot.major = {major.u * share, major.v * share};
    Vec3<Real> total{};
    for (int i = 0; i < foot.spots; ++i) {
        node.tally(Operation::loop_turn, 1);
        node.tally(Operation::to_float, 1);
        node.tally(Operation::multiply_add, 3);
        const Real steps =
            from_double<Real>(i) - from_double<Real>(0.5) * from_double<Real>(foot.spots - 1);
        spot.at = {center.u + steps * spot.major.u, center.v + steps * spot.major.v};
        total = add_scaled(node, total, share, texture_color(node, layer, spot));
    }
    return total;
}

}  // namespace pxm::kernels
