// Random admissible words, drawn in pieces of many maps at once: for each follow set the words that
// may stand there, with their probabilities.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "host/fractal/system/rifs.hpp"
#include "host/math/alias_table.hpp"

namespace pxm::host {

/// Blending along a word is affine in the colour it starts from: c -> keep c + add.
struct ColorBlend {
    double keep = 1;      // the share of the first colour that is left
    glm::dvec3 add{0.0};  // what is added to it

    /// The colour that becomes of c.
    [[nodiscard]] glm::dvec3 of(const glm::dvec3& c) const { return keep * c + add; }
    /// This one first, then `inner`: the outermost map paints first.
    [[nodiscard]] ColorBlend then(const ColorBlend& inner) const {
        return {inner.keep * keep, inner.of(add)};
    }
};

/// A word as one step of a descent.
struct Passage {
    Affine map;                // of the whole word
    ColorBlend blend;          // of all its colours
    std::uint32_t inside = 0;  // the follow set of what stands inside it
};

class RandomWords {  // draws words
  public:
    /// In a follow set, map m comes with probability weight_m over the sum of the set's weights;
    /// alike where all are 0. `colors` (r,g,b,a) per map.
    RandomWords(const Rifs& rifs, const std::vector<double>& weights,
                const std::vector<glm::dvec4>& colors);

    /// A word that stands in follow set `set`, by 64 random bits. Every infinite word begins with
    /// exactly one of those that may come.
    [[nodiscard]] const Passage& draw(std::uint32_t set, std::uint64_t bits) const {
        const Choice& choice = sets_[set];
        return passages_[choice.passages[choice.table.draw(bits)]];
    }

  private:
    struct Choice {
        AliasTable table;
        std::vector<std::uint32_t> passages;
    };
    /// A word that may come, and how likely it is.
    struct Likely {
        double probability = 0;
        std::uint32_t passage = 0;
        int maps = 1;
        bool operator<(const Likely& other) const { return probability < other.probability; }
    };

    [[nodiscard]] Choice choice(const Rifs& rifs, const std::vector<std::vector<double>>& share,
                                std::size_t set, std::size_t most_words);
    [[nodiscard]] bool is_worth_splitting(const Likely& word) const;

    std::vector<Passage> passages_;  // first those of single maps
    std::vector<Choice> sets_;
};

}  // namespace pxm::host
