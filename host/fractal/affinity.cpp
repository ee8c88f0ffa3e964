#include "host/fractal/affinity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/fractal/similarity.hpp"
#include "host/fractal/word_sums.hpp"

namespace pxm::host {

namespace {

constexpr double word_count = 60'000;  // of one length
constexpr int longest_word = 16;
constexpr double rounding = 1e-9;  // of an upper bound, added to it
constexpr int estimate_halvings = 40;

Affinity exact(const Interval& dimension, const std::string& why) {
    return {dimension.middle(), dimension.high * (1 + rounding) + rounding, true, why, 1};
}

/// phi^d is submultiplicative: once the sums over words of one length fall, all longer ones do.
double upper_bound(const Rifs& rifs, const WordTable& table,
                   const std::vector<std::vector<int>>& components) {
    const double d = critical_exponent([&](double exponent) {
                         return growth(word_sums(rifs, table, exponent), components);
                     }).high;
    return d * (1 + rounding) + rounding;
}

/// The d at which words of one letter more add up to the same: what bounded factors make of short
/// words' sums cancels out.
double growth_estimate(const Rifs& rifs, const WordTable& table, const WordTable& shorter,
                       const std::vector<std::vector<int>>& components, double upper) {
    const auto grows = [&](double d) {
        return spectral_radius(word_sums(rifs, table, d), components) >=
               spectral_radius(word_sums(rifs, shorter, d), components);
    };
    double low = 0;
    double high = upper;
    for (int n = 0; n < estimate_halvings; ++n) {
        const double d = (low + high) / 2;
        (grows(d) ? low : high) = d;
    }
    return (low + high) / 2;
}

}  // namespace

Affinity affinity_dimension(const Rifs& rifs) {
    if (const auto similarity = similarity_dimension(rifs)) {
        return exact(*similarity, "exact: all maps are similitudes");
    }
    if (const auto form = affinity_of_triangular(rifs)) return exact(form->dimension, form->why);
    const auto components = cyclic_components(rifs);
    Affinity result;
    result.word_length = affordable_length(rifs, longest_word, word_count);
    const WordTable table = word_table(rifs, result.word_length);
    result.upper = upper_bound(rifs, table, components);
    if (result.word_length == 1) {
        result.value = result.upper;
        result.why = "the upper bound from single maps: there are too many words of two maps";
        return result;
    }
    const WordTable shorter = word_table(rifs, result.word_length - 1);
    result.upper = std::min(result.upper, upper_bound(rifs, shorter, components));
    result.value = growth_estimate(rifs, table, shorter, components, result.upper);
    result.why = fmt::format("estimated from the growth of the word sums, words of {} and {} maps",
                             result.word_length - 1, result.word_length);
    return result;
}

}  // namespace pxm::host
