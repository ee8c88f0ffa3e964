#include "host/fractal/system/word_lipschitz.hpp"

#include <cmath>

#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t word_limit = 40'000;  // of one length

struct Word {
    std::vector<int> maps;
    Affine map;
    double product = 1;
};

void compare(const Word& word, WordLipschitz& worst) {
    const double actual = lipschitz_constant(word.map);  // Sec. 16.2
    if (!(actual > 0)) return;
    const double above = word.product / actual;                    // Eq. 16.1
    const double below = actual / determinant_constant(word.map);  // Eq. 16.3, Erratum 6
    if (above > worst.product_over_actual || worst.product_word.empty()) {
        worst.product_over_actual = above;
        worst.product_word = word.maps;
    }
    if (below > worst.actual_over_determinant || worst.determinant_word.empty()) {
        worst.actual_over_determinant = below;
        worst.determinant_word = word.maps;
    }
}

}  // namespace

std::vector<WordLipschitz> word_lipschitz(const Rifs& rifs, int longest) {
    std::vector<Word> words;
    std::vector<double> lip;
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        lip.push_back(lipschitz_constant(rifs.maps[m]));
        words.push_back({{static_cast<int>(m)}, rifs.maps[m], lip.back()});
    }
    std::vector<WordLipschitz> result;
    while (true) {
        WordLipschitz worst;
        worst.length = static_cast<int>(result.size()) + 1;
        worst.words = static_cast<long>(words.size());
        for (const Word& word : words) compare(word, worst);
        result.push_back(worst);
        if (worst.length == longest) return result;
        std::size_t count = 0;
        for (const Word& word : words) {
            count += rifs.follow_sets[rifs.follow_of[word.maps.back()]].maps.size();
            if (count > word_limit) return result;
        }
        std::vector<Word> longer;
        for (const Word& word : words) {
            for (const int m : rifs.follow_sets[rifs.follow_of[word.maps.back()]].maps) {
                Word next{word.maps, then(rifs.maps[m], word.map), word.product * lip[m]};
                next.maps.push_back(m);
                longer.push_back(std::move(next));
            }
        }
        words = std::move(longer);
    }
}

}  // namespace pxm::host
