// Random graphs whose points tell their words, and the exact measure of their words.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "host/fractal/measure/chaos_game.hpp"
#include "host/math/affine.hpp"
#include "tests/host/fractal/systems.hpp"
#include "tests/support/chi_square.hpp"

namespace pxm::host::systems {

/// Map m takes x to (x + m) / (maps + 1): the digits of a point are the maps of its word.
inline Rifs digits_on_a_graph(unsigned seed) {
    std::mt19937_64 random(seed);
    const int maps = 2 + static_cast<int>(random() % 5);
    std::vector<Affine> digit;
    for (int m = 0; m < maps; ++m) {
        const double ratio = 1.0 / (maps + 1);
        digit.push_back(map({scaling(glm::dvec3{ratio}), translation({m * ratio, 0, 0})}));
    }
    std::vector<std::vector<int>> follow(maps);
    for (std::vector<int>& followers : follow) {
        for (int m = 0; m < maps; ++m) {
            if (random() % 2 == 0) followers.push_back(m);
        }
        if (followers.empty()) followers.push_back(static_cast<int>(random() % maps));
    }
    return with_graph(digit, follow);
}

/// The probabilities of all words of `length` maps, by number in base maps + 1.
inline std::map<std::uint64_t, double> word_probabilities(const Rifs& rifs,
                                                          const std::vector<double>& weights,
                                                          int length) {
    struct Word {
        std::uint64_t number;
        int set;
        double probability;
    };
    std::vector<Word> words{{0, rifs.start, 1}};
    for (int n = 0; n < length; ++n) {
        std::vector<Word> longer;
        for (const Word& word : words) {
            const std::vector<int>& maps = rifs.follow_sets[word.set].maps;
            double sum = 0;
            for (const int m : maps) sum += weights[m];
            for (const int m : maps) {
                longer.push_back({word.number * (rifs.maps.size() + 1) + m, rifs.follow_of[m],
                                  word.probability * weights[m] / sum});
            }
        }
        words = std::move(longer);
    }
    std::map<std::uint64_t, double> result;
    for (const Word& word : words) result[word.number] += word.probability;
    return result;
}

/// How well the first maps of the points' words fit, and how well pairs of points drawn one after
/// the other fit to two that know nothing of each other. `outside`: points of no admissible word.
struct Fit {
    test::ChiSquare words;
    test::ChiSquare pairs;
    int outside = 0;
};

inline Fit fit_of_words(const Rifs& rifs, const std::vector<double>& weights, int length,
                        int points, std::uint64_t seed) {
    const auto expected = word_probabilities(rifs, weights, length);
    const auto single = word_probabilities(rifs, weights, 1);
    ChaosGame game(rifs, weights, std::vector<glm::dvec4>(rifs.maps.size()), seed);
    const double base = static_cast<double>(rifs.maps.size()) + 1;
    std::map<std::uint64_t, double> count;
    std::map<std::pair<std::uint64_t, std::uint64_t>, double> pairs;
    std::uint64_t last = 0;
    Fit fit;
    for (int i = 0; i < points; ++i) {
        const double x = game.next().place.x + 1e-12;
        const auto number = static_cast<std::uint64_t>(x * std::pow(base, length));
        const auto first = static_cast<std::uint64_t>(x * base);
        fit.outside += expected.count(number) == 0;
        ++count[number];
        if (i % 2 == 1) ++pairs[{last, first}];
        last = first;
    }
    std::vector<double> counts;
    std::vector<double> probabilities;
    for (const auto& [number, probability] : expected) {
        counts.push_back(count[number]);
        probabilities.push_back(probability);
    }
    fit.words = test::chi_square(counts, probabilities, points);
    counts.clear();
    probabilities.clear();
    for (const auto& [a, pa] : single) {
        for (const auto& [b, pb] : single) {
            counts.push_back(pairs[{a, b}]);
            probabilities.push_back(pa * pb);
        }
    }
    fit.pairs = test::chi_square(counts, probabilities, points / 2);
    return fit;
}

/// Weights from 0.05 to 1.
inline std::vector<double> random_weights(const Rifs& rifs, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> weight(0.05, 1);
    std::vector<double> weights;
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) weights.push_back(weight(random));
    return weights;
}

}  // namespace pxm::host::systems
