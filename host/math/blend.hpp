// Maps between two maps: what an animation shows while one turns into the other.
#pragma once

#include <string>
#include <variant>

#include "host/math/affine.hpp"

namespace pxm::host {

/// The map that lies at `share` of the way from `a` (0) to `b` (1), or why there is none. Each is
/// taken apart by the polar decomposition into a turn and a stretch. The turn goes the short way
/// about one axis at constant speed, the logarithm of the stretch and the translation go straight:
/// no map on the way is flat, and of two similarities all are similarities. Two maps that mirror
/// are blended as what they are besides the inversion x -> -x. Refused: a map that squashes flat,
/// which has no logarithm; one that mirrors and one that does not, as every way between them passes
/// a flat one; turns that lie half a turn apart, between which no way is the short one.
[[nodiscard]] std::variant<Affine, std::string> blend(const Affine& a, const Affine& b,
                                                      double share);

}  // namespace pxm::host
