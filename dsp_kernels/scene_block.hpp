// The scene block: what the host broadcasts into every node's back frame buffer (Ch. 19), as words
// in the node's format. A record has its integers first, then its numbers;
// host/node_program/write_scene_block.cpp fills records in, and the kernels read them back.
// Addresses are word addresses from the start of the block.
//
// All lengths are in *scene units*: the host moves the eye to the origin and scales by a power of
// two, so that a node's numbers stay near 1 whatever the units of the scene.
#pragma once

#include <cstdint>

namespace pxm::kernels {

/// Where a record's fields lie: `integers` words, then numbers of `R` words each.
template <std::uint32_t R, std::uint32_t Integers, std::uint32_t Reals>
struct Record {
    static constexpr std::uint32_t words = Integers + Reals * R;  // that it takes
    /// The place of an integer, in words from the record's start.
    [[nodiscard]] static constexpr std::uint32_t integer(std::uint32_t field) { return field; }
    /// The place of a number, in words from the record's start.
    [[nodiscard]] static constexpr std::uint32_t real(std::uint32_t field) {
        return Integers + field * R;
    }
};

/// How the normals of a path's cells are weighted (Ch. 17).
enum class ShadingMode : std::uint32_t { constant, low_pass, high_pass, facet };
/// Whether eye rays meet in the eye or go side by side.
enum class Projection : std::uint32_t { perspective, orthographic };
/// Kinds of bounding volumes (Sec. 12.2).
enum class Volume : std::uint32_t { sphere, box, oriented, hull, cone, cylinder };
/// How diameters of cells are estimated (Ch. 16).
enum class Lipschitz : std::uint32_t { product, determinant, polar };
/// Of intersection: Alg. 12.4, Ch. 13.
enum class Method : std::uint32_t { heap, fast };
enum class LightKind : std::uint32_t { directional, point };  // how far away a light is

/// What the maps of an object squash so much that a ray needs care on its way into their cells.
enum Squash : std::uint32_t {
    squash_flat = 1,   // singular maps, which were lifted (dsp_kernels/flatness)
    squash_steep = 2,  // maps with a SteepRecord (dsp_kernels/steepness)
};

/// Cells end where they are small enough, and nowhere else.
inline constexpr std::uint32_t unlimited_levels = 0xFFFF'FFFF;

/// At address 0. An eye ray of pixel (x, y) goes through corner + (x + u) across + (y + v) down,
/// with the place (u, v) of its sample in the pixel.
template <std::uint32_t R>
struct HeaderRecord : Record<R, 19, 26> {
    using Base = Record<R, 19, 26>;  // where its fields lie
    // integers
    static constexpr std::uint32_t width = Base::integer(0);         // of the image, pixels
    static constexpr std::uint32_t height = Base::integer(1);        // of the image, pixels
    static constexpr std::uint32_t crop = Base::integer(2);          // x0, y0, x1, y1, half open
    static constexpr std::uint32_t object_count = Base::integer(6);  // how many there are
    static constexpr std::uint32_t objects = Base::integer(7);       // address of the first record
    static constexpr std::uint32_t light_count = Base::integer(8);   // how many there are
    static constexpr std::uint32_t lights = Base::integer(9);        // address of the first record
    static constexpr std::uint32_t shading = Base::integer(10);      // a ShadingMode
    static constexpr std::uint32_t projection = Base::integer(11);   // a Projection
    static constexpr std::uint32_t cell_cap = Base::integer(12);  // most cells tested for one ray
    static constexpr std::uint32_t bounces = Base::integer(13);   // most mirrors one after another
    static constexpr std::uint32_t sample_count = Base::integer(14);  // eye rays of a pixel
    static constexpr std::uint32_t samples = Base::integer(15);  // address of their places: x, y in
                                                                 // [0,1) of the pixel, two numbers
    static constexpr std::uint32_t plane_count = Base::integer(16);  // how many there are
    static constexpr std::uint32_t planes = Base::integer(17);       // address of the first record
    static constexpr std::uint32_t method = Base::integer(18);       // a Method
    // numbers
    static constexpr std::uint32_t eye = Base::real(0);     // where eye rays begin: the origin
    static constexpr std::uint32_t corner = Base::real(3);  // the upper left one of pixel (0, 0)
    static constexpr std::uint32_t across = Base::real(6);  // from a pixel to the one on its right
    static constexpr std::uint32_t down = Base::real(9);    // from a pixel to the one below
    static constexpr std::uint32_t forward = Base::real(12);       // the unit vector along the view
    static constexpr std::uint32_t pixel_at_eye = Base::real(15);  // p(t) = pixel_at_eye
    static constexpr std::uint32_t pixel_growth = Base::real(16);  //      + pixel_growth t
    static constexpr std::uint32_t detail = Base::real(17);   // terminal at so many pixels; tau_min
    static constexpr std::uint32_t fade = Base::real(18);     // covers begin to show: tau_max
    static constexpr std::uint32_t ambient = Base::real(19);  // k_a c_a of Eq. 17.1
    static constexpr std::uint32_t background = Base::real(22);    // r, g, b, linear
    static constexpr std::uint32_t sample_share = Base::real(25);  // 1 / sample_count
};

/// What a beam knows of the places in a pixel (covers: area): it follows the one place of the eye's
/// ray. First of how many bits places are in the first 0, 1, ... count columns, and in so many
/// rows; then the places themselves.
template <std::uint32_t R>
struct BeamRecord : Record<R, 3, 0> {
    using Base = Record<R, 3, 0>;                                    // where its fields lie
    static constexpr std::uint32_t count = Base::integer(0);         // of the places
    static constexpr std::uint32_t first_column = Base::integer(1);  // of the eye's ray
    static constexpr std::uint32_t first_row = Base::integer(2);     // of the eye's ray
    static constexpr std::uint32_t columns = Base::words;            // the tables
};

/// One object: an instance of a linear fractal.
template <std::uint32_t R>
struct ObjectRecord : Record<R, 6, 29> {
    using Base = Record<R, 6, 29>;                                  // where its fields lie
    static constexpr std::uint32_t start_set = Base::integer(0);    // address of a follow set
    static constexpr std::uint32_t lipschitz = Base::integer(1);    // a Lipschitz
    static constexpr std::uint32_t levels = Base::integer(2);       // or unlimited_levels
    static constexpr std::uint32_t symbol_bits = Base::integer(3);  // of a map in a cell's word
    static constexpr std::uint32_t squash = Base::integer(4);       // bits of Squash
    static constexpr std::uint32_t enclosing = Base::integer(5);    // a record like this, of a cell
                                                                    // around it that shades; or 0
    static constexpr std::uint32_t inverse = Base::real(0);         // M^-1 of the instance
    static constexpr std::uint32_t linear = Base::real(12);         // T of the instance
    static constexpr std::uint32_t constant = Base::real(21);       // its Lipschitz constant
    static constexpr std::uint32_t smallest_pixel = Base::real(22);  // p never falls below
    static constexpr std::uint32_t color = Base::real(23);           // r, g, b, linear
    static constexpr std::uint32_t diffuse = Base::real(26);         // k_d of Eq. 17.1
    static constexpr std::uint32_t opacity = Base::real(27);         // of its volumes; 1: solid
    static constexpr std::uint32_t reflect = Base::real(28);         // share of a mirror's image
};

/// What may stand inside a map: its bounding volume and the maps that may come next.
/// The addresses of the maps follow the record, in the order of the maps; with covers: area, what
/// the attractor covers of the volume on average comes after them. What an oriented box or a
/// hull needs besides its centre lies at an address of its own.
template <std::uint32_t R>
struct FollowSetRecord : Record<R, 3, 10> {
    using Base = Record<R, 3, 10>;                                // where its fields lie
    static constexpr std::uint32_t volume = Base::integer(0);     // a Volume
    static constexpr std::uint32_t map_count = Base::integer(1);  // of those that may come next
    static constexpr std::uint32_t shape = Base::integer(2);      // OrientedRecord or HullRecord
    static constexpr std::uint32_t center = Base::real(0);        // rays are re-based to here
    static constexpr std::uint32_t radius = Base::real(3);        // of a sphere, cone or cylinder
    static constexpr std::uint32_t low = Base::real(3);           // corners of a box
    static constexpr std::uint32_t high = Base::real(6);          // the corner opposite to `low`
    static constexpr std::uint32_t diameter = Base::real(9);  // the largest distance of two points
    static constexpr std::uint32_t maps = Base::words;        // the first of their addresses
};

/// An oriented box: the points x with |axis . (x - center)| <= 1 for each of its three axes.
template <std::uint32_t R>
struct OrientedRecord : Record<R, 0, 9> {
    /// Three half edges, each over the square of its length.
    static constexpr std::uint32_t axes = Record<R, 0, 9>::real(0);
};

/// A hull. Its half-spaces follow the record.
template <std::uint32_t R>
struct HullRecord : Record<R, 1, 0> {
    static constexpr std::uint32_t count = Record<R, 1, 0>::integer(0);   // of half-spaces
    static constexpr std::uint32_t half_spaces = Record<R, 1, 0>::words;  // the first of them
};

/// The points x with normal . (x - center) <= offset.
template <std::uint32_t R>
struct HalfSpaceRecord : Record<R, 0, 4> {
    using Base = Record<R, 0, 4>;                           // where its fields lie
    static constexpr std::uint32_t normal = Base::real(0);  // a unit vector
    static constexpr std::uint32_t offset = Base::real(3);  // from the volume's centre
};

/// One map of a system.
template <std::uint32_t R>
struct MapRecord : Record<R, 3, 33> {
    using Base = Record<R, 3, 33>;                                 // where its fields lie
    static constexpr std::uint32_t follow_set = Base::integer(0);  // address
    static constexpr std::uint32_t lost_axes = Base::integer(2);   // of a lifted singular map
    static constexpr std::uint32_t symbol = Base::integer(1);      // its number from 0
    static constexpr std::uint32_t inverse = Base::real(0);        // W_i^-1
    static constexpr std::uint32_t linear = Base::real(12);        // T_i
    static constexpr std::uint32_t constant = Base::real(21);  // Lip w_i, or the cube root of |det|
    static constexpr std::uint32_t color = Base::real(22);     // r, g, b, a
    static constexpr std::uint32_t lost = Base::real(26);      // up to two unit axes it squashes
    static constexpr std::uint32_t least = Base::real(32);     // least diameter of its cell, as a
                                                               // share of the cell's around it
};

/// Comes after the record of a map of a steep object: its inverse in two parts, of which one alone
/// stretches very much. x W^-1 = x across + (x . axis + height) up. Of a map that is not steep
/// itself the axis is 0.
template <std::uint32_t R>
struct SteepRecord : Record<R, 0, 19> {
    using Base = Record<R, 0, 19>;                           // where its fields lie
    static constexpr std::uint32_t across = Base::real(0);   // onto the plane through 0 across `up`
    static constexpr std::uint32_t axis = Base::real(12);    // as long as the map's stretch
    static constexpr std::uint32_t height = Base::real(15);  // of the image of 0
    static constexpr std::uint32_t up = Base::real(16);      // unit vector
};

/// A light.
template <std::uint32_t R>
struct LightRecord : Record<R, 2, 6> {
    using Base = Record<R, 2, 6>;                              // where its fields lie
    static constexpr std::uint32_t kind = Base::integer(0);    // a LightKind
    static constexpr std::uint32_t shadow = Base::integer(1);  // 1: it casts shadows
    static constexpr std::uint32_t place =
        Base::real(0);  // unit direction to the light, or position
    static constexpr std::uint32_t color = Base::real(3);  // r, g, b, linear
};

}  // namespace pxm::kernels
