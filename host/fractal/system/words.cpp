#include "host/fractal/system/words.hpp"

#include <algorithm>
#include <limits>

namespace pxm::host {

namespace {

constexpr double short_enough = 0.999;  // a word is cut here: a Lip nearer to 1 bounds nothing well

/// The word with one more map inside it.
ContractingWord longer(const ContractingWord& word, const Rifs& rifs, int map) {
    const Affine& inner = rifs.maps[map];
    ContractingWord result{word.from, rifs.follow_of[map], word.length + 1, 0, {}, {}};
    result.linear = word.linear * BracketMatrix{inner.linear};
    result.translation = word.linear * bracket(inner.translation) + word.translation;
    result.lip = norm_at_most(result.linear);
    return result;
}

}  // namespace

std::optional<WordCode> contracting_words(const Rifs& rifs, long budget) {
    WordCode code;
    std::vector<ContractingWord> open;
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        const int set = static_cast<int>(s);
        open.push_back({set, set, 0, 1, BracketMatrix{glm::dmat3{1.0}}, {}});
    }
    // First in, first out: the budget is spent on all words alike.
    for (std::size_t next = 0; next < open.size(); ++next) {
        const ContractingWord word = open[next];
        // No longer word of such a one could be proven to contract.
        if (!(word.lip < std::numeric_limits<double>::infinity())) return std::nullopt;
        code.worst_prefix = std::max(code.worst_prefix, word.lip);
        for (const int m : rifs.follow_sets[word.to].maps) {
            if (--budget < 0) return std::nullopt;
            ContractingWord next_word = longer(word, rifs, m);
            (next_word.lip <= short_enough ? code.words : open).push_back(next_word);
        }
    }
    return code;
}

}  // namespace pxm::host
