#include "host/render/point_games.hpp"

#include <algorithm>
#include <glm/vec4.hpp>

#include "host/compile/proven_rifs.hpp"
#include "host/fractal/dimension/default_weights.hpp"
#include "host/scene/default_objects.hpp"

namespace pxm::host {

namespace {

std::vector<double> weights_of(const IfsBlock& block, const Rifs& rifs) {
    std::vector<double> weights = default_weights(rifs);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (block.maps[i].weight) weights[i] = *block.maps[i].weight;
    }
    return weights;
}

}  // namespace

std::vector<PointGame> point_games(const Scene& scene, std::uint64_t seed,
                                   Diagnostics& diagnostics) {
    constexpr glm::dvec3 base_color{0.9, 0.9, 0.9};
    std::vector<PointGame> games;
    for (const ObjectBlock& object : objects_of(scene)) {
        if (!object.ifs) {
            diagnostics.warning(object.position, "an object without ifs has no points: left out");
            continue;
        }
        const auto block = std::ranges::find(scene.ifs, *object.ifs, &IfsBlock::name);
        const auto proven = prove_rifs(*block, diagnostics);
        if (!proven) continue;
        std::vector<glm::dvec4> colors;
        for (const MapBlock& map : block->maps)
            colors.push_back(map.color.value_or(glm::dvec4{0.0}));
        const glm::dvec4 paint = object.color.value_or(glm::dvec4{0.0});
        games.push_back({ChaosGame(proven->rifs, weights_of(*block, proven->rifs), colors, seed,
                                   static_cast<std::uint32_t>(games.size())),
                         compose(object.commands),
                         base_color * (1 - paint.a) + glm::dvec3{paint} * paint.a});
    }
    if (games.empty() && !diagnostics.has_errors()) {
        diagnostics.error({}, "the scene has no linear fractal to draw points of");
    }
    return games;
}

std::vector<PointChunk> point_chunks(std::size_t games, std::uint64_t count) {
    std::vector<PointChunk> chunks;
    for (std::size_t i = 0; i < games; ++i) {
        const auto begin = [&](std::size_t game) {
            return count / games * game + std::min<std::uint64_t>(count % games, game);
        };
        std::uint64_t left = begin(i + 1) - begin(i);
        for (std::uint32_t number = 0; left > 0; ++number) {
            const std::uint64_t points = std::min(left, ChaosGame::chunk_points);
            chunks.push_back({i, number, points});
            left -= points;
        }
    }
    return chunks;
}

}  // namespace pxm::host
