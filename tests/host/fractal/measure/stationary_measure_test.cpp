// The chaos game draws the exact measure of a graph with weights (level of each test: 1e-5).
#include "tests/host/fractal/measure/stationary_measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "host/compile/build_rifs.hpp"
#include "host/fractal/dimension/default_weights.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::host {
namespace {

Rifs system_of(const std::string& text) {
    Diagnostics diagnostics;
    const Scene scene = parse_text("test.pxm", text, diagnostics);
    Rifs rifs = build_rifs(scene.ifs.at(0), diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.text(scene.files);
    return rifs;
}

std::vector<glm::dvec3> cloud(const Rifs& rifs, int points) {
    ChaosGame game(rifs, default_weights(rifs), std::vector<glm::dvec4>(rifs.maps.size()), 1);
    std::vector<glm::dvec3> result;
    for (int i = 0; i < points; ++i) result.push_back(game.next().place);
    return result;
}

/// Whether x is even on [low, high], in 64 bins.
bool is_even(const std::vector<glm::dvec3>& points, double low, double high) {
    constexpr int bins = 64;
    std::vector<double> count(bins);
    for (const glm::dvec3& p : points) {
        const int bin = static_cast<int>((p.x - low) / (high - low) * bins);
        ++count[std::clamp(bin, 0, bins - 1)];
    }
    return test::chi_square(count, std::vector<double>(bins, 1.0 / bins), double(points.size()))
        .fits();
}

std::size_t different_x(const std::vector<glm::dvec3>& points) {
    std::set<double> x;
    for (const glm::dvec3& p : points) x.insert(p.x);
    return x.size();
}

const char* const two_states =
    "rifs segment { newmap a scale: 1/2 newmap b scale: 1/2 translate: 1/2,0,0"
    " newmap c scale: 1/2 newmap d scale: 1/2 translate: 1/2,0,0"
    " follow: a -> a,b follow: b -> c,d follow: c -> a,b follow: d -> c,d start: a,b }";

const char* const dragon =
    "rifs dragon { newmap l1 scale: 1/sqrt(2) rotate: z,45"
    " newmap l2 scale: 1/sqrt(2) rotate: z,-135 translate: 1/2,1/2,0"
    " newmap r1 scale: 1/sqrt(2) rotate: z,45"
    " newmap r2 scale: 1/sqrt(2) rotate: z,45 translate: 1/2,1/2,0"
    " follow: l1 -> l1,l2 follow: l2 -> r1,r2 follow: r1 -> l1,l2 follow: r2 -> r1,r2"
    " start: l1,l2 }";

TEST(StationaryMeasure, words_come_as_often_as_weights_say_and_points_know_nothing_of_each_other) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Rifs rifs = systems::digits_on_a_graph(seed);
        for (const std::vector<double>& weights :
             {systems::random_weights(rifs, seed), default_weights(rifs)}) {
            const systems::Fit fit = systems::fit_of_words(rifs, weights, 3, 3000, seed);
            EXPECT_TRUE(fit.words.fits()) << "seed " << seed << ": " << fit.words.value;
            EXPECT_TRUE(fit.pairs.fits()) << "seed " << seed << ": " << fit.pairs.value;
            EXPECT_EQ(fit.outside, 0) << "seed " << seed;
        }
    }
}

TEST(StationaryMeasure, both_states_of_a_segment_cover_it_evenly_and_no_point_comes_twice) {
    const std::vector<glm::dvec3> points = cloud(system_of(two_states), 10'000);
    EXPECT_TRUE(is_even(points, 0, 1));
    EXPECT_EQ(different_x(points), points.size());
}

TEST(StationaryMeasure, the_dragon_has_its_box_and_no_holes) {
    const std::vector<glm::dvec3> points = cloud(system_of(dragon), 20'000);
    glm::dvec3 low{1e9};
    glm::dvec3 high{-1e9};
    std::set<std::pair<int, int>> cells;
    for (const glm::dvec3& p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
        cells.emplace(std::floor(p.x * 16), std::floor(p.y * 16));
    }
    EXPECT_NEAR(low.x, -1.0 / 3, 0.015);
    EXPECT_NEAR(low.y, -1.0 / 3, 0.015);
    EXPECT_NEAR(high.x, 7.0 / 6, 0.015);
    EXPECT_NEAR(high.y, 2.0 / 3, 0.015);
    EXPECT_EQ(different_x(points), points.size());
    // Against all cells of the words of 16 maps.
    std::set<std::pair<int, int>> whole;
    const Rifs rifs = system_of(dragon);
    struct Word {
        Affine place;
        int set;
    };
    std::vector<Word> words{{Affine{}, rifs.start}};
    for (int n = 0; n < 12; ++n) {
        std::vector<Word> longer;
        for (const Word& word : words) {
            for (const int m : rifs.follow_sets[word.set].maps) {
                longer.push_back({then(rifs.maps[m], word.place), rifs.follow_of[m]});
            }
        }
        words = std::move(longer);
    }
    for (const Word& word : words) {
        const glm::dvec3 p = word.place.point({0, 0, 0});
        whole.emplace(std::floor(p.x * 16), std::floor(p.y * 16));
    }
    std::size_t missing = 0;
    for (const auto& cell : whole) missing += cells.count(cell) == 0;
    EXPECT_LE(missing, whole.size() / 50) << whole.size();  // cells with a corner of the set alone
}

TEST(StationaryMeasure, by_default_pieces_of_unequal_size_are_covered_evenly) {
    const double phi = std::numbers::phi;
    // A long piece is a long and a short one, a short one is a long one: lengths phi and 1.
    const Rifs fibonacci = system_of(
        "let r = 1/phi rifs f { newmap ll scale: r newmap ls scale: r translate: 1,0,0"
        " newmap sl scale: r follow: ll -> ll,ls follow: ls -> sl follow: sl -> ll,ls"
        " start: ll,ls }");
    EXPECT_TRUE(is_even(cloud(fibonacci, 10'000), 0, phi));
    // In a line, lengths count, not volumes.
    const Rifs parts = system_of(
        "ifs parts { newmap scale: 0.3 newmap scale: 0.6 translate: 0.3,0,0"
        " newmap scale: 0.1 translate: 0.9,0,0 }");
    EXPECT_TRUE(is_even(cloud(parts, 10'000), 0, 1));
}

TEST(DefaultWeights, go_by_the_determinant_and_starve_no_map) {
    const Rifs fern = system_of(
        "ifs fern { newmap scale: 0,0.16,0.5 newmap scale: 0.8 rotate: x,10 translate: 0,1,0"
        " newmap scale: 0.4 rotate: y,20 translate: 1,0,0 }");
    const std::vector<double> weights = default_weights(fern);
    EXPECT_NEAR(weights[1] / weights[2], 8, 1e-12);
    EXPECT_GT(weights[0], 0);
    EXPECT_LT(weights[0], weights[2]);
}

TEST(DefaultWeights, on_a_graph_are_the_dominant_eigenvector) {
    const Rifs rifs = system_of(
        "rifs g { newmap scale: 1/2 newmap scale: 1/2 translate: 0.5,0,0"
        " follow: 1 -> 1,2 follow: 2 -> 1 start: 1,2 }");
    const std::vector<double> weights = default_weights(rifs);
    EXPECT_NEAR(weights[0] / weights[1], std::numbers::phi, 1e-9);
}

}  // namespace
}  // namespace pxm::host
