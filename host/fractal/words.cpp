#include "host/fractal/words.hpp"

#include <algorithm>

#include "host/fractal/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr double short_enough = 0.999;  // a word is cut here: a Lip nearer to 1 bounds nothing well

}  // namespace

std::optional<WordCode> contracting_words(const Rifs& rifs, long budget) {
    WordCode code;
    std::vector<ContractingWord> open;
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        const int set = static_cast<int>(s);
        open.push_back({set, set, 0, 1, {}});
    }
    // First in, first out: the budget is spent on all words alike.
    for (std::size_t next = 0; next < open.size(); ++next) {
        const ContractingWord word = open[next];
        code.worst_prefix = std::max(code.worst_prefix, word.lip);
        for (const int m : rifs.follow_sets[word.to].maps) {
            if (--budget < 0) return std::nullopt;
            ContractingWord longer{word.from, rifs.follow_of[m], word.length + 1, 0,
                                   then(rifs.maps[m], word.map)};
            longer.lip = lipschitz_constant(longer.map);
            (longer.lip <= short_enough ? code.words : open).push_back(longer);
        }
    }
    return code;
}

}  // namespace pxm::host
