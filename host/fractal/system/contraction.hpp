// Does a system contract? A map of norm 1 may belong to a system that does (thesis-notes, "Singular
// and non-contractive maps"). Tried in order: (a) the largest cycle mean of log Lip is negative
// (Karp); (b) the spectral radius of sum T_i (x) T_i is below 1; (c) all words up to a budget are
// bounded.
#pragma once

#include <string>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// How it was shown that a system contracts.
enum class ContractionProof { cycle_mean, spectral_radius, words, none };
/// What is known of how a system shrinks.
struct Contraction {
    ContractionProof proof = ContractionProof::none;  // how it was shown
    double rate = 0;       // a factor below 1 per map, in the long run, by the proof found
    int word_length = 1;   // for `words`: every word of this length contracts by rate^word_length
    std::string obstacle;  // if none: the map or cycle and its value, for the message
};

[[nodiscard]] Contraction prove_contraction(const Rifs& rifs);  // tries the three in turn

}  // namespace pxm::host
