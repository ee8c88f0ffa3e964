#include "host/fractal/chaos_game.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>

#include "host/fractal/inner_points.hpp"

namespace pxm::host {

namespace {

constexpr double floor_share = 1e-3;        // of the largest weight
constexpr double settled = 1e-12;           // what is left of the first points' place and colour
constexpr long longest_warm_up = 100'000;   // steps, however slow the contraction
constexpr long sweep_budget = 1'000'000;    // points drawn to begin with, all sets together
constexpr std::uint64_t restart_mask = 15;  // the walk begins again at the start once in 16 steps

AliasTable table_of(const std::vector<std::uint32_t>& maps, const std::vector<double>& weights) {
    std::vector<double> own;
    own.reserve(maps.size());
    for (const std::uint32_t map : maps) own.push_back(weights[map]);
    if (std::ranges::all_of(own, [](double w) { return w == 0; })) {
        std::ranges::fill(own, 1.0);
    }
    return AliasTable(own);
}

}  // namespace

std::vector<double> default_weights(const Rifs& rifs) {
    std::vector<double> weights;
    for (const Affine& map : rifs.maps) weights.push_back(std::abs(determinant(map)));
    const double largest = *std::ranges::max_element(weights);
    for (double& weight : weights) {
        weight = largest > 0 ? std::max(weight, floor_share * largest) : 1;
    }
    return weights;
}

ChaosGame::ChaosGame(const Rifs& rifs, const std::vector<double>& weights,
                     const std::vector<glm::dvec4>& colors, double rate, std::uint64_t seed)
    : points_(rifs.follow_sets.size()),
      start_(static_cast<std::uint32_t>(rifs.start)),
      walker_(start_),
      single_(rifs.follow_sets.size() == 1),
      seed_(seed) {
    for (const FollowSet& set : rifs.follow_sets) {
        std::vector<std::uint32_t> maps(set.maps.begin(), set.maps.end());
        AliasTable table = table_of(maps, weights);
        sets_.push_back({std::move(table), std::move(maps)});
    }
    for (std::size_t i = 0; i < rifs.maps.size(); ++i) {
        const Affine& map = rifs.maps[i];
        const glm::dvec4& color = colors[i];
        steps_.push_back({{map.linear[0], map.linear[1], map.linear[2]},
                          map.translation,
                          glm::dvec3{color} * color.a,
                          1 - color.a,
                          static_cast<std::uint32_t>(rifs.follow_of[i])});
    }
    const double bounded_rate = std::clamp(rate, 0.0, 1 - 1e-9);
    const double steps = bounded_rate > 0 ? std::log(settled) / std::log(bounded_rate) : 1;
    const auto sets = static_cast<double>(sets_.size());
    const long warm_up = static_cast<long>(
        std::min<double>(static_cast<double>(longest_warm_up), 43 + 2 * steps * sets));  // Alg. 7.1
    settle(rifs, static_cast<long>(std::min<double>(longest_warm_up, 1 + steps)));
    for (long i = 0; i < warm_up; ++i) (void)next();
}

// A set that the walk rarely comes to would keep its first point for long: that point belongs to
// the attractor, and every set is drawn as often as the others before the walk begins.
void ChaosGame::settle(const Rifs& rifs, long rounds) {
    const Points inside = inner_point_of_each(rifs);
    for (std::size_t s = 0; s < points_.size(); ++s) points_[s].place = inside[s];
    const long sets = static_cast<long>(sets_.size());
    for (long round = std::min(rounds, sweep_budget / sets + 1); round > 0; --round) {
        for (long s = 0; s < sets; ++s) (void)draw(static_cast<std::uint32_t>(s));
    }
}

std::uint64_t ChaosGame::random_bits() {
    if (has_spare_) {
        has_spare_ = false;
        return spare_bits_;
    }
    using Generator = r123::Philox4x32;
    const Generator::ctr_type counter{
        {static_cast<std::uint32_t>(counter_), static_cast<std::uint32_t>(counter_ >> 32), 0, 0}};
    const Generator::key_type key{
        {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)}};
    ++counter_;
    const auto bits = Generator{}(counter, key);
    spare_bits_ = std::uint64_t{bits[2]} << 32 | bits[3];
    has_spare_ = true;
    return std::uint64_t{bits[0]} << 32 | bits[1];
}

std::uint32_t ChaosGame::draw(std::uint32_t set) {
    const Set& s = sets_[set];
    const Step& step = steps_[s.maps[s.table.draw(random_bits())]];
    const CloudPoint& from = points_[step.inside];
    const glm::dvec3& x = from.place;
    CloudPoint to;
    to.place = step.offset + x.x * step.row[0] + x.y * step.row[1] + x.z * step.row[2];
    // The outermost map paints first: c -> keep c + paint, then what the inner word does.
    to.blend.keep = from.blend.keep * step.keep;
    to.blend.add = from.blend.keep * step.paint + from.blend.add;
    points_[set] = to;
    return step.inside;
}

void ChaosGame::refresh() {
    walker_ = draw(walker_);
    if ((counter_ & restart_mask) == 0) walker_ = start_;
}

const CloudPoint& ChaosGame::next() {
    if (!single_) refresh();
    (void)draw(start_);
    return points_[start_];
}

}  // namespace pxm::host
