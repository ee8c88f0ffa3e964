// A finite code of words that all contract, such that every infinite word is a row of them: the
// last resort for proving contraction (thesis-notes, "Singular and non-contractive maps", (c)).
#pragma once

#include <optional>
#include <vector>

#include "host/fractal/system/contraction.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/math/bracket_matrix.hpp"

namespace pxm::host {

/// A word that starts in follow set `from` and inside which follow set `to` stands.
struct ContractingWord {
    int from = 0;
    int to = 0;
    int length = 0;
    double lip = 0;  // no smaller than that of the composed map, below 1
    BracketMatrix linear;
    BracketVector translation;
};

struct WordCode {
    std::vector<ContractingWord> words;
    double worst_prefix = 1;  // the largest Lip of a proper prefix, the empty word's 1 included
};

/// Every admissible word of every follow set, cut where it is first sure to contract, whatever
/// rounding did on the way. Nothing if more than `budget` words had to be looked at.
[[nodiscard]] std::optional<WordCode> contracting_words(const Rifs& rifs, long budget);

inline constexpr long word_budget = 200'000;  // words of 312 bytes

/// prove_contraction() that looks at no more than `most_words` words in place of word_budget.
[[nodiscard]] Contraction prove_contraction(const Rifs& rifs, long most_words);

}  // namespace pxm::host
