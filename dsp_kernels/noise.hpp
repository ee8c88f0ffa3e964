// Noise from whole numbers: the same on every node and host, whatever its arithmetic, up to the
// rounding of its numbers. Only adds, shifts and exclusive ors: the DSP32 has no integer multiply.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/vector.hpp"

namespace pxm::kernels {

/// Three whole numbers scrambled into one.
template <NodeLike Node>
[[nodiscard]] std::uint32_t scramble(Node& node, std::uint32_t a, std::uint32_t b,
                                     std::uint32_t c) noexcept {
    node.tally(Operation::call, 1);
    node.tally(Operation::integer, 38);
    std::uint32_t h = 0x9E37'79B9;  // 2^32 / phi: any number with mixed bits does
    for (const std::uint32_t word : {a, b, c}) {
        h += word;
        h += h << 10;
        h ^= h >> 6;
        h += h << 3;
        h ^= h >> 17;
        h += h << 11;
    }
    h ^= h >> 11;
    h += h << 15;
    h ^= h >> 16;
    return h;
}

/// Part number `part` of a scrambled number, 8 bits each, as a number from 0 up to 1.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real share_of(Node& node, std::uint32_t scrambled, std::uint32_t part) noexcept {
    node.tally(Operation::integer, 2);
    node.tally(Operation::to_float, 1);
    node.tally(Operation::multiply_add, 1);
    return from_double<Real>(static_cast<int>(scrambled >> 8 * part & 0xFF)) *
           from_double<Real>(1.0 / 256);
}

/// A smooth function of the plane with values from -1 to 1 and features of size 1.
/// Preconditions: whole parts of 16 bits.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] Real noise(Node& node, Real x, Real y, std::uint32_t seed) noexcept {
    node.tally(Operation::call, 1);
    node.tally(Operation::to_float, 4);
    node.tally(Operation::multiply_add, 18);
    node.tally(Operation::integer, 6);
    const int column = floor_integer(x);
    const int row = floor_integer(y);
    const auto corner = [&](int right, int up) {
        const std::uint32_t h = scramble(node, static_cast<std::uint32_t>(column + right),
                                         static_cast<std::uint32_t>(row + up), seed);
        return from_double<Real>(static_cast<int>(h >> 17)) * from_double<Real>(1.0 / 16384) -
               Real(1);
    };
    const auto smooth = [](Real f) { return f * f * (Real(3) - f - f); };
    const Real right = smooth(x - from_double<Real>(column));
    const Real up = smooth(y - from_double<Real>(row));
    const Real low_left = corner(0, 0);
    const Real low = low_left + right * (corner(1, 0) - low_left);
    const Real high_left = corner(0, 1);
    const Real high = high_left + right * (corner(1, 1) - high_left);
    return low + up * (high - low);
}

}  // namespace pxm::kernels
