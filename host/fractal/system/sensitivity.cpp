#include "host/fractal/system/sensitivity.hpp"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "host/math/lipschitz.hpp"

namespace pxm::host {

Sensitivity sensitivity(const Rifs& rifs) {
    constexpr double contracts = 0.99;
    constexpr double rounding = 1 + 1e-12;  // of products of a few maps
    constexpr std::size_t most_words = 50'000;
    constexpr double endless = std::numeric_limits<double>::infinity();
    struct Word {
        glm::dmat3 linear;
        int set;
    };
    std::vector<Word> words;
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s)
        words.push_back({glm::dmat3{1.0}, static_cast<int>(s)});
    Sensitivity total;
    double largest = 1;
    while (true) {
        std::vector<Word> longer;
        total.lipschitz += largest;
        total.squares += largest * largest;
        for (const Word& word : words) {
            for (const int m : rifs.follow_sets[static_cast<std::size_t>(word.set)].maps)
                longer.push_back({word.linear * rifs.maps[static_cast<std::size_t>(m)].linear,
                                  rifs.follow_of[static_cast<std::size_t>(m)]});
            if (longer.size() > most_words) return {endless, endless};
        }
        largest = 0;
        for (const Word& word : longer)
            largest = std::max(largest, singular_values(word.linear).values[0] * rounding);
        // All longer words are made of such words and of shorter ones.
        if (largest <= contracts)
            return {total.lipschitz / (1 - largest), total.squares / (1 - largest * largest)};
        words = std::move(longer);
    }
}

}  // namespace pxm::host
