// A system's maps in the numbers that the scene's text writes: 1/3 is a third, 0.1 a tenth,
// sqrt(3) the root of three. The text is read a second time, beside the doubles that pictures are
// made of, which this leaves as they are.
#pragma once

#include "host/fractal/exact/ball_system.hpp"
#include "host/fractal/exact/exact_system.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// Of a block of the scene. A scene that was not read from a text has its doubles for numbers.
/// Throws exact::NotExact where a number is in no number field of moderate size: pi, a blend, what
/// changes with time.
[[nodiscard]] exact::WrittenMaps written_maps(const Scene& scene, const IfsBlock& block);

/// The same numbers in balls. Throws exact::NotExact where these do not tell them either: a blend,
/// what changes with time, a root of 0 that is not 0 exactly.
[[nodiscard]] exact::BallMaps balls_as_written(const Scene& scene, const IfsBlock& block);

}  // namespace pxm::host
