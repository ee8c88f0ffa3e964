// Sums over all words of one length of the singular value function of their composed maps: what the
// affinity dimension is made of (Eq. 6.12 to 6.14 with Erratum 7).
#pragma once

#include <array>
#include <vector>

#include "host/fractal/system/growth.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// Logarithms of a1, a1 a2 and a1 a2 a3, where a1 >= a2 >= a3 are the singular values; -infinity
/// stands for 0.
using LogStretch = std::array<double, 3>;

/// Of one map.
[[nodiscard]] LogStretch log_stretch(const Affine& map);

/// log phi^d = log(a1 ... a_{m-1} a_m^{d-m+1}), m-1 < d <= m; above the n dimensions that the
/// attractor lies in, 1 to 3, d/n log(a1 ... an) (Eq. 6.12 and 6.13, Erratum 7).
[[nodiscard]] double log_singular_value_function(const LogStretch& stretch, double d, int n = 3);

/// The words of one length that begin with some map and stay in one component.
struct WordStretch {
    int first_map = 0;
    int to = 0;  // the follow set of what stands inside the word
    LogStretch stretch{};
    LogStretch above{};  // proven upper bounds of it
};

struct WordTable {
    int length = 1;
    std::vector<WordStretch> words;       // by first map, rising
    std::vector<std::size_t> first_word;  // per map, and one more: where its words begin
};

/// All words of that length. Precondition: their number was found affordable.
[[nodiscard]] WordTable word_table(const Rifs& rifs, int length);

/// The largest length, at most `longest`, whose words are at most `budget`, and at least 1.
[[nodiscard]] int affordable_length(const Rifs& rifs, int longest, double budget);

enum class Rounding { nearest, above };

/// Entry (s, t): the sum of phi^d over the words from follow set s to follow set t, in n
/// dimensions. phi^d is submultiplicative, so the matrix of k + l letters is at most the product of
/// those of k and l.
[[nodiscard]] StepMatrix word_sums(const Rifs& rifs, const WordTable& table, double d, int n,
                                   Rounding rounding);

/// The same, of words of one letter, with any weight a map.
[[nodiscard]] StepMatrix map_sums(const Rifs& rifs, const std::vector<double>& weight);

}  // namespace pxm::host
