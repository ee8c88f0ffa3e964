// The floor's part of the scene block: planes, the textures that lie on them, and what those are
// made of. Texels lie in texture memory, all else in the back frame buffer (Ch. 19).
#pragma once

#include "dsp_kernels/scene_block.hpp"

namespace pxm::kernels {

enum class TextureKind : std::uint32_t { image, wood, inclusion };  // what a texture is made of

/// A plane, x . normal = offset, with its layers of textures.
template <std::uint32_t R>
struct PlaneRecord : Record<R, 2, 9> {
    using Base = Record<R, 2, 9>;                                   // where its fields lie
    static constexpr std::uint32_t layer_count = Base::integer(0);  // of its textures
    static constexpr std::uint32_t layers = Base::integer(1);       // address of the first record
    static constexpr std::uint32_t normal = Base::real(0);          // a unit vector
    static constexpr std::uint32_t offset = Base::real(3);          // in scene units
    static constexpr std::uint32_t color = Base::real(4);           // r, g, b, linear
    static constexpr std::uint32_t diffuse = Base::real(7);         // k_d of Eq. 17.1
    static constexpr std::uint32_t reflect = Base::real(8);         // share of a mirror's image
};

/// A texture as it lies on a plane: a point x is at u = (x - origin) . across repeats and at
/// v = (x - origin) . along. The origin is the corner of repeat (first_u, first_v), near the eye.
template <std::uint32_t R>
struct LayerRecord : Record<R, 3, 9> {
    using Base = Record<R, 3, 9>;                               // where its fields lie
    static constexpr std::uint32_t texture = Base::integer(0);  // address
    static constexpr std::uint32_t first_u = Base::integer(1);  // of its origin, an integer
    static constexpr std::uint32_t first_v = Base::integer(2);  // of its origin, an integer
    static constexpr std::uint32_t origin = Base::real(0);      // in scene units
    static constexpr std::uint32_t across = Base::real(3);      // repeats a scene unit
    static constexpr std::uint32_t along = Base::real(6);       // the same of v
};

/// A texture: an image in several sizes, wood, or a flat attractor.
template <std::uint32_t R>
struct TextureRecord : Record<R, 3, 13> {
    using Base = Record<R, 3, 13>;                                  // where its fields lie
    static constexpr std::uint32_t kind = Base::integer(0);         // a TextureKind
    static constexpr std::uint32_t level_count = Base::integer(1);  // of an image
    static constexpr std::uint32_t levels = Base::integer(2);       // address of the finest
    static constexpr std::uint32_t start_set = Base::integer(2);    // address, of an inclusion
    static constexpr std::uint32_t color = Base::real(0);           // r, g, b, linear
    static constexpr std::uint32_t color2 = Base::real(3);          // r, g, b, linear
    static constexpr std::uint32_t mean = Base::real(6);            // its colour from far away
    static constexpr std::uint32_t unit = Base::real(9);    // of an image: a texel's unit, squared
    static constexpr std::uint32_t aspect = Base::real(9);  // of wood: length of a board / width
    static constexpr std::uint32_t corner = Base::real(9);  // of an inclusion: where its system's
                                                            // origin lies in a repeat, u and v
    static constexpr std::uint32_t step = Base::real(11);   // repeats a unit of its system, u and v
};

/// An image at one size. A texel's word has the square roots of red, green and blue, 10 bits each.
template <std::uint32_t R>
struct ImageLevelRecord : Record<R, 3, 0> {
    using Base = Record<R, 3, 0>;                              // where its fields lie
    static constexpr std::uint32_t width = Base::integer(0);   // texels
    static constexpr std::uint32_t height = Base::integer(1);  // texels
    static constexpr std::uint32_t texels = Base::integer(2);  // address in texture memory, by rows
};

/// The flat counterpart of FollowSetRecord: a ball about what may stand inside a map. The addresses
/// of the maps that may come next follow.
template <std::uint32_t R>
struct PointSetRecord : Record<R, 1, 3> {
    using Base = Record<R, 1, 3>;                                 // where its fields lie
    static constexpr std::uint32_t map_count = Base::integer(0);  // of those that may come next
    static constexpr std::uint32_t center = Base::real(0);        // of the ball, two numbers
    static constexpr std::uint32_t radius = Base::real(2);        // of the ball
    static constexpr std::uint32_t maps = Base::words;            // the first of their addresses
};

/// A map of the plane: x' = x T + a.
template <std::uint32_t R>
struct PointMapRecord : Record<R, 1, 6> {
    using Base = Record<R, 1, 6>;                                 // where its fields lie
    static constexpr std::uint32_t point_set = Base::integer(0);  // address
    static constexpr std::uint32_t linear = Base::real(0);        // T by rows
    static constexpr std::uint32_t offset = Base::real(4);        // a
};

}  // namespace pxm::kernels
