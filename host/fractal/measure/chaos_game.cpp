#include "host/fractal/measure/chaos_game.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/fractal/bounds/inner_points.hpp"

namespace pxm::host {

namespace {

constexpr double resolution = 0x1p-54;  // of the attractor's size
constexpr double enough = 2;           // times what inner points show of E_s is more than all of it
constexpr int most_passages = 10'000;  // of a descent, however slow the contraction

double size_of(const glm::dmat3& linear) {
    return std::sqrt(glm::dot(linear[0], linear[0]) + glm::dot(linear[1], linear[1]) +
                     glm::dot(linear[2], linear[2]));
}

double reach_from(const glm::dvec3& center, const Points& points) {
    double reach = 0;
    for (const glm::dvec3& point : points) reach = std::max(reach, glm::distance(center, point));
    return enough * reach;
}

}  // namespace

ChaosGame::ChaosGame(const Rifs& rifs, const std::vector<double>& weights,
                     const std::vector<glm::dvec4>& colors, std::uint64_t seed,
                     std::uint32_t number)
    : words_(rifs, weights, colors),
      inner_(inner_point_of_each(rifs)),
      start_(static_cast<std::uint32_t>(rifs.start)),
      seed_(seed),
      number_(number) {
    const std::vector<Points> points = inner_points(rifs);
    for (std::size_t s = 0; s < points.size(); ++s) {
        reach_.push_back(reach_from(inner_[s], points[s]));
    }
    negligible_ = resolution * reach_[start_];
}

// A point takes at most half as many counters as passages, a chunk fewer than 2^32.
void ChaosGame::seek(std::uint32_t chunk) {
    static_assert(chunk_points * most_passages / 2 < std::uint64_t{1} << 32);
    counter_ = std::uint64_t{chunk} << 32;
    has_spare_ = false;
}

std::uint64_t ChaosGame::random_bits() {
    if (has_spare_) {
        has_spare_ = false;
        return spare_bits_;
    }
    // The seed is the key and the game's number is part of the counter: a key takes different
    // counters to different bits, so no sum of seed and number makes one game repeat another.
    using Generator = r123::Philox4x32;
    const Generator::ctr_type counter{{static_cast<std::uint32_t>(counter_),
                                       static_cast<std::uint32_t>(counter_ >> 32), number_, 0}};
    const Generator::key_type key{
        {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)}};
    ++counter_;
    const auto bits = Generator{}(counter, key);
    spare_bits_ = std::uint64_t{bits[2]} << 32 | bits[3];
    has_spare_ = true;
    return std::uint64_t{bits[0]} << 32 | bits[1];
}

CloudPoint ChaosGame::next() {
    Affine place;
    ColorBlend blend;
    std::uint32_t set = start_;
    for (int passages = 0; passages < most_passages; ++passages) {
        const Passage& passage = words_.draw(set, random_bits());
        place = then(passage.map, place);
        blend = blend.then(passage.blend);
        set = passage.inside;
        if (size_of(place.linear) * reach_[set] <= negligible_) break;
    }
    return {place.point(inner_[set]), blend};
}

}  // namespace pxm::host
