// The three Lipschitz methods of Ch. 16 along words: the product of the maps' constants (Eq. 16.1)
// is an upper bound, the cube root of the determinant (Eq. 16.3) a lower one (Erratum 6), and the
// largest singular value of the composed map is the constant (Sec. 16.2).
#pragma once

#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// Of all words of one length, those where the bounds are worst.
struct WordLipschitz {
    int length = 1;                      // in maps
    long words = 0;                      // so many there are
    double product_over_actual = 1;      // how much too large the product bound is, at worst
    std::vector<int> product_word;       // ... and the word
    double actual_over_determinant = 1;  // how much too small the determinant bound; infinite if 0
    std::vector<int> determinant_word;   // ... and the word
};

/// For lengths 1 to `longest`, or fewer where there are too many words. Zero maps do not count.
[[nodiscard]] std::vector<WordLipschitz> word_lipschitz(const Rifs& rifs, int longest);

}  // namespace pxm::host
