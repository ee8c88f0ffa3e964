// A point of the attractor inside a cell, to so many digits that a camera can fly to it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "host/math/precise.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

inline constexpr int point_decimals = 60;

/// In the world: the point of the cell that `word` leads to in an object with an ifs, whose address
/// goes on with the maps that may come there in turn, for ever. Precondition: the scene was found
/// right, and the word is one of the object's system.
[[nodiscard]] PreciseVec3 exact_point(const Scene& scene, const ObjectBlock& object,
                                      const std::vector<int>& word);

/// As a camera's `look` takes it, number by number.
[[nodiscard]] std::array<std::string, 3> decimal_texts(const PreciseVec3& point);

}  // namespace pxm::host
