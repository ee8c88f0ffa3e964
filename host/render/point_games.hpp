// A scene's attractors drawn the explicit way (Alg. 7.1): which games draw which points of a cloud,
// so that whoever wants the points may draw them in any order and in any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/fractal/measure/chaos_game.hpp"
#include "host/math/affine.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// An object with the game that draws it.
struct PointGame {
    ChaosGame game;
    Affine instance;
    glm::dvec3 color;
};

/// One game per object that is a fractal, of a scene that check_scene found right. A scene without
/// any is an error that goes to `diagnostics`.
[[nodiscard]] std::vector<PointGame> point_games(const Scene& scene, std::uint64_t seed,
                                                 Diagnostics& diagnostics);

/// Points that one thread draws at a time: of one object, a chunk of its game or the last one's
/// beginning.
struct PointChunk {
    std::size_t game = 0;
    std::uint32_t number = 0;
    std::uint64_t points = 0;
};

/// The chunks of a cloud of `count` points in the order of the points: objects one after another,
/// with equal shares.
[[nodiscard]] std::vector<PointChunk> point_chunks(std::size_t games, std::uint64_t count);

}  // namespace pxm::host
