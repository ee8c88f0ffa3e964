#include "host/fractal/system/contraction.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/fractal/system/cycle_mean.hpp"
#include "host/fractal/system/quadratic_norm.hpp"
#include "host/fractal/system/words.hpp"
#include "host/math/spectrum.hpp"

namespace pxm::host {

namespace {

constexpr double margin = 1e-9;          // a rate nearer to 1 is not told from 1
constexpr std::size_t maps_spoken = 12;  // of a cycle, in a message

bool is_finite(const Affine& map) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (!std::isfinite(map.linear[i][j])) return false;
        }
        if (!std::isfinite(map.translation[i])) return false;
    }
    return true;
}

std::string spoken_cycle(const Rifs& rifs, const std::vector<int>& cycle) {
    std::string text;
    for (std::size_t i = 0; i < std::min(cycle.size(), maps_spoken); ++i) {
        text += rifs.map_names[cycle[i]] + " -> ";
    }
    if (cycle.size() > maps_spoken) text += "... -> ";
    return text + rifs.map_names[cycle.front()];
}

std::string obstacle_text(const Rifs& rifs, const CycleMean& worst) {
    if (worst.cycle.size() == 1) {
        return fmt::format("{} has Lipschitz constant {:.6g}", spoken_name(rifs, worst.cycle[0]),
                           std::exp(worst.mean));
    }
    const double growth = std::exp(worst.mean * static_cast<double>(worst.cycle.size()));
    return fmt::format("the cycle {} grows by {:.6g}", spoken_cycle(rifs, worst.cycle), growth);
}

/// True if going round the cycle again and again does not shrink: then nothing can prove
/// contraction.
bool never_shrinks(const Rifs& rifs, const std::vector<int>& cycle) {
    glm::dmat3 round{1.0};
    for (const int m : cycle) round = round * rifs.maps[m].linear;
    const auto radius = spectral_radius(round);
    return radius && *radius >= 1 - margin;
}

/// The certificate of a code of words as the contract of `words` states it. A word of n maps is
/// code words and less than one more, so it shrinks by worst_prefix * rate^(n - longest); with the
/// square root of the rate there is an n from which that is below rate^n.
Contraction by_words(const WordCode& code) {
    Contraction result;
    double log_rate = -std::numeric_limits<double>::infinity();
    int longest = 1;
    for (const ContractingWord& word : code.words) {
        log_rate = std::max(log_rate, std::log(std::max(word.lip, 1e-300)) / word.length);
        longest = std::max(longest, word.length);
    }
    const double n = 2 * (std::log(code.worst_prefix) - longest * log_rate) / -log_rate;
    constexpr int longest_length = std::numeric_limits<int>::max() / 2;
    if (!(n < longest_length)) return result;
    result.proof = ContractionProof::words;
    result.rate = std::exp(log_rate / 2);
    // One more: its half of log_rate is far more than the rounding of these logarithms.
    result.word_length = static_cast<int>(std::ceil(n)) + 1;
    return result;
}

}  // namespace

// Each proof is looked for in double and then checked in brackets, for the maps as the doubles that
// they are: what rounding may have made up is no proof.
Contraction prove_contraction(const Rifs& rifs, long most_words) {
    Contraction result;
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        if (is_finite(rifs.maps[m])) continue;
        result.obstacle = spoken_name(rifs, static_cast<int>(m)) + " is not finite";
        return result;
    }
    const CycleMean worst = largest_cycle_mean(rifs);
    if (const double rate = proven_rate(rifs, weights_of(worst)); rate < 1 - margin) {
        result.proof = ContractionProof::cycle_mean;
        result.rate = rate;
        return result;
    }
    if (!never_shrinks(rifs, worst.cycle)) {
        if (const auto norm = contracting_norm(rifs); norm && norm->rate < 1 - margin) {
            result.proof = ContractionProof::spectral_radius;
            result.rate = norm->rate;
            return result;
        }
        if (const auto code = contracting_words(rifs, most_words)) {
            if (Contraction found = by_words(*code); found.proof == ContractionProof::words) {
                return found;
            }
        }
    }
    result.obstacle = obstacle_text(rifs, worst);
    return result;
}

Contraction prove_contraction(const Rifs& rifs) { return prove_contraction(rifs, word_budget); }

}  // namespace pxm::host
