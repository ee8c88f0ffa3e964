#include "host/fractal/dimension/affinity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/fractal/bounds/affine_hull.hpp"
#include "host/fractal/dimension/conformal.hpp"
#include "host/fractal/dimension/similarity.hpp"
#include "host/fractal/system/word_sums.hpp"

namespace pxm::host {

namespace {

constexpr double word_count = 60'000;  // of one length
constexpr int longest_word = 16;
constexpr int estimate_halvings = 40;
constexpr double wide = 1e-6;  // an interval that tells no six digits

Affinity exact(const Interval& dimension, const std::string& why) {
    if (dimension.error() > wide * std::max(1.0, dimension.high)) {
        return {dimension.high, dimension.high, false,
                fmt::format("between {:.6g} and {:.6g}: longer words would tell more",
                            dimension.low, dimension.high),
                1};
    }
    return {dimension.middle(), dimension.high, true, why, 1};
}

/// The words of one system, in so many dimensions.
struct Words {
    const Rifs& rifs;
    int dimensions;
    std::vector<std::vector<int>> components;
};

/// phi^d is submultiplicative: once the sums over words of one length fall, all longer ones do.
double upper_bound(const Words& words, const WordTable& table) {
    return critical_exponent([&](double d) {
               return growth(word_sums(words.rifs, table, d, words.dimensions, Rounding::above),
                             words.components);
           })
        .high;
}

/// The d at which words of one letter more add up to the same: what bounded factors make of short
/// words' sums cancels out.
double growth_estimate(const Words& words, const WordTable& table, const WordTable& shorter,
                       double upper) {
    const auto radius = [&](const WordTable& of, double d) {
        return spectral_radius(word_sums(words.rifs, of, d, words.dimensions, Rounding::nearest),
                               words.components);
    };
    double low = 0;
    double high = upper;
    for (int n = 0; n < estimate_halvings; ++n) {
        const double d = (low + high) / 2;
        (radius(table, d) >= radius(shorter, d) ? low : high) = d;
    }
    return (low + high) / 2;
}

Affinity estimate(const Rifs& rifs, int dimensions) {
    if (!branches(rifs)) return {0, 0, true, "exact: no map has two that may follow for ever", 1};
    const Words words{rifs, dimensions, cyclic_components(rifs)};
    Affinity result;
    result.word_length = affordable_length(rifs, longest_word, word_count);
    const WordTable table = word_table(rifs, result.word_length);
    result.upper = upper_bound(words, table);
    if (result.word_length == 1) {
        result.value = result.upper;
        result.why =
            std::string("the upper bound from single maps: there are too many words of two maps");
        return result;
    }
    const WordTable shorter = word_table(rifs, result.word_length - 1);
    result.upper = std::min(result.upper, upper_bound(words, shorter));
    result.value = growth_estimate(words, table, shorter, result.upper);
    result.why = fmt::format("estimated from the growth of the word sums, words of {} and {} maps",
                             result.word_length - 1, result.word_length);
    return result;
}

/// Precondition: maps have entries in the first n axes only.
Affinity in_dimensions(const Rifs& rifs, int n) {
    if (const auto ratios = conformal_ratios(rifs, n)) {
        Affinity found = exact(exponent_of_ratios(rifs, ratios->log_ratio, ratios->error),
                               "exact: all maps are similitudes in other coordinates");
        found.conformal = true;
        return found;
    }
    if (const auto form = affinity_of_triangular(rifs, n)) return exact(form->dimension, form->why);
    return estimate(rifs, n);
}

}  // namespace

Affinity affinity_dimension(const Rifs& rifs) {
    if (const auto similarity = similarity_dimension(rifs)) {
        return exact(*similarity, "exact: all maps are similitudes");
    }
    const std::vector<AffineHull> hulls = affine_hulls(rifs);
    const int n = recurrent_dimension(rifs, hulls);
    if (n == 0 || n == 3) return in_dimensions(rifs, 3);
    if (const auto flat = within_hulls(rifs, hulls)) return in_dimensions(*flat, n);
    return estimate(rifs, 3);
}

}  // namespace pxm::host
