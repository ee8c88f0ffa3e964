// Woodgrain: boards, one a repeat, shifted from row to row. Each is cut from a log of its own, so
// that the rings about the log's axis show as lines and arches. Everything that a spot is too wide
// for fades into its mean. Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/floor_block.hpp"
#include "dsp_kernels/footprint.hpp"
#include "dsp_kernels/noise.hpp"

namespace pxm::kernels {

/// Looks of the wood; lengths in widths of a board.
namespace wood {
inline constexpr double rings = 9;            // rings a width
inline constexpr double ring_mean = 1.0 / 3;  // of the darkness of a ring
inline constexpr double ring_share = 0.5;     // of a board's darkness
inline constexpr double tint_share = 0.28;    // whole boards are darker or lighter
inline constexpr double fibre_share = 0.22;   // fibres, of a board's darkness
/// Darkness of wood from far away.
inline constexpr double mean = ring_share * ring_mean + (tint_share + fibre_share) / 2;
inline constexpr double fibre_length = 1.0 / 1.5;  // along the board
inline constexpr double fibre_width = 1.0 / 40;    // across it
inline constexpr double wobble_length = 2.5;       // rings are no circles
inline constexpr double wobble_width = 0.7;        // across the board
inline constexpr double wobble = 0.6;              // of them, in rings
inline constexpr double seam = 1.0 / 50;           // the gap between boards
inline constexpr double seam_depth = 0.7;          // how much of the light is lost in it
inline constexpr double least_ring = 0.15;         // rings are no sharper, in rings
inline constexpr double least_seam = 1e-3;  // spots are no narrower: digits of the seam's filter
inline constexpr double widest = 1024;      // wider spots show nothing but the mean
}  // namespace wood

/// 0 below 0, 1 above 1.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real clamped(Node& node, Real x) noexcept {
    node.tally(Operation::select, 2);
    if (x < Real(0)) return Real(0);
    return Real(1) < x ? Real(1) : x;
}

/// How much of a detail of size 1 is left in a spot of that width: all up to 1/2, nothing from 1.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real left_of_detail(Node& node, Real width) noexcept {
    node.tally(Operation::multiply_add, 2);
    return clamped(node, Real(2) - width - width);
}

/// The share of a spot, `width` about x, that lies in stripes of width `stripe` about the whole
/// numbers. A difference of integrals, so exact.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real share_in_stripes(Node& node, Real x, Real width, Real stripe) noexcept {
    constexpr Real half = from_double<Real>(0.5);
    node.tally(Operation::call, 1);
    node.tally(Operation::divide, 1);
    node.tally(Operation::multiply_add, 9);
    node.tally(Operation::to_float, 4);
    node.tally(Operation::select, 2);
    const auto integral = [&](Real end) {
        const Real shifted = end + half * stripe;
        const Real whole = from_double<Real>(floor_integer(shifted));
        const Real rest = shifted - whole;
        return whole * stripe + (rest < stripe ? rest : stripe);
    };
    return (integral(x + half * width) - integral(x - half * width)) / width;
}

/// The mean darkness, over a spot `width` about r, of rings at the whole numbers: it grows with the
/// square of the way through a ring, and the next ring begins light. Exact as well.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real ring_darkness(Node& node, Real r, Real width) noexcept {
    constexpr Real half = from_double<Real>(0.5);
    constexpr Real third = from_double<Real>(wood::ring_mean);
    node.tally(Operation::call, 1);
    node.tally(Operation::divide, 1);
    node.tally(Operation::multiply_add, 11);
    node.tally(Operation::to_float, 4);
    const auto integral = [&](Real end) {
        const Real whole = from_double<Real>(floor_integer(end));
        const Real rest = end - whole;
        return third * (whole + rest * rest * rest);
    };
    return (integral(r + half * width) - integral(r - half * width)) / width;
}

/// A spot on a board: from its left end and lower edge, in widths of a board.
template <class Real>
struct BoardSpot {
    Real x;               // along the board
    Real y;               // across it
    Real wide_x;          // extent of the spot
    Real wide_y;          // of the spot, across
    std::uint32_t board;  // a number that is the board's own
};

/// Rings of the board's log: the distance from its axis, which is askew.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real rings_at(Node& node, const BoardSpot<Real>& spot) noexcept {
    constexpr Real rings = from_double<Real>(wood::rings);
    node.tally(Operation::multiply_add, 20);
    node.tally(Operation::square_root, 1);
    node.tally(Operation::reciprocal, 1);
    node.tally(Operation::select, 3);
    const Real bend = from_double<Real>(wood::wobble) *
                      noise(node, spot.x * from_double<Real>(1 / wood::wobble_length),
                            spot.y * from_double<Real>(1 / wood::wobble_width), spot.board);
    const Real slope =
        from_double<Real>(0.16) * share_of(node, spot.board, 2) - from_double<Real>(0.08);
    const Real side =
        spot.y - (from_double<Real>(2.4) * share_of(node, spot.board, 0) - from_double<Real>(0.7));
    const Real depth = from_double<Real>(0.15) +
                       from_double<Real>(0.8) * share_of(node, spot.board, 1) + slope * spot.x;
    const Real distance = square_root(side * side + depth * depth + from_double<Real>(1e-4));
    const Real per_width = rings * reciprocal(distance);
    Real width = absolute(per_width * side) * spot.wide_y +
                 absolute(per_width * depth * slope) * spot.wide_x +
                 from_double<Real>(wood::wobble / wood::wobble_width) * spot.wide_y;
    if (width < from_double<Real>(wood::least_ring)) width = from_double<Real>(wood::least_ring);
    return ring_darkness(node, rings * distance + bend, width);
}

/// How dark a board is at a spot on it, from 0 to 1.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real board_darkness(Node& node, const BoardSpot<Real>& spot) noexcept {
    constexpr Real half = from_double<Real>(0.5);
    node.tally(Operation::call, 1);
    node.tally(Operation::multiply_add, 8);
    node.tally(Operation::select, 1);
    const Real across = spot.wide_y * from_double<Real>(1 / wood::fibre_width);
    const Real along = spot.wide_x * from_double<Real>(1 / wood::fibre_length);
    Real fibre = half;
    const Real left = left_of_detail(node, across < along ? along : across);
    if (Real(0) < left) {
        fibre = half + half * left *
                           noise(node, spot.x * from_double<Real>(1 / wood::fibre_length),
                                 spot.y * from_double<Real>(1 / wood::fibre_width), spot.board + 1);
    }
    return from_double<Real>(wood::ring_share) * rings_at(node, spot) +
           from_double<Real>(wood::tint_share) * share_of(node, spot.board, 3) +
           from_double<Real>(wood::fibre_share) * fibre;
}

/// How much of a board's own look is left where a spot of that width is at `place` (0 to 1) on it:
/// at its edges both boards have become the mean, so that no edge is hard.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real left_of_board(Node& node, Real place, Real width) noexcept {
    node.tally(Operation::multiply_add, 5);
    node.tally(Operation::select, 1);
    const Real other = Real(1) - place;
    const Real edge = place < other ? place : other;
    const Real fades = clamped(node, Real(2) - width);
    if (!(edge + edge < width)) return fades;
    node.tally(Operation::divide, 1);
    return fades * (edge + edge) / width;
}

/// The colour of wood within a spot: `color` is the light wood, `color2` the dark.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Vec3<Real> wood_color(Node& node, std::uint32_t texture, std::uint32_t first_u,
                                    std::uint32_t first_v, const Spot<Real>& spot) noexcept {
    using Texture = TextureRecord<real_words<Real>>;
    constexpr Real mean = from_double<Real>(wood::mean);
    constexpr Real least = from_double<Real>(wood::least_seam);
    constexpr Real seam = from_double<Real>(wood::seam);
    node.tally(Operation::call, 1);
    node.tally(Operation::multiply_add, 12);
    node.tally(Operation::select, 6);
    node.tally(Operation::reciprocal, 1);
    node.tally(Operation::integer, 4);
    const Real aspect = node.shape_real(texture + Texture::aspect);
    const Real per_length = reciprocal(aspect);
    Real wide_v = absolute(spot.minor.v) + absolute(spot.major.v);
    Real wide_x = (absolute(spot.minor.u) + absolute(spot.major.u)) * aspect;
    if (wide_v < least) wide_v = least;
    if (wide_x < least) wide_x = least;
    const Place<Real> row = place_of(node, spot.at.v);
    const std::uint32_t row_number = row.repeat + first_v;
    const Real shift = share_of(node, scramble(node, row_number, 0, 0), 0);
    const Place<Real> length = place_of(node, spot.at.u + shift);
    const std::uint32_t board = scramble(node, row_number, length.repeat + first_u, 1);

    const Real left = left_of_board(node, row.fraction, wide_v) *
                      left_of_board(node, length.fraction, wide_x * per_length);
    Real darkness = mean;
    node.tally(Operation::compare_branch, 1);
    if (Real(0) < left) {
        const BoardSpot<Real> on_board{length.fraction * aspect, row.fraction, wide_x, wide_v,
                                       board};
        darkness = mean + left * (board_darkness(node, on_board) - mean);
    }
    const Real open = Real(1) - share_in_stripes(node, row.fraction, wide_v, seam);
    const Real long_open =
        Real(1) - share_in_stripes(node, length.fraction, wide_x * per_length, seam * per_length);
    const Real lit = Real(1) - from_double<Real>(wood::seam_depth) * (Real(1) - open * long_open);
    const Vec3<Real> light = read_vector(node, texture + Texture::color);
    const Vec3<Real> dark = read_vector(node, texture + Texture::color2);
    return scale(node, lit, add_scaled(node, light, darkness, subtract(node, dark, light)));
}

}  // namespace pxm::kernels
