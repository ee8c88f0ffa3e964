// The exact measure of many graphs, with more points and longer words (level of each test: 1e-5).
#include <gtest/gtest.h>

#include "host/fractal/dimension/default_weights.hpp"
#include "tests/host/fractal/measure/stationary_measure.hpp"

namespace pxm::host {
namespace {

TEST(StationaryMeasureSlow, words_of_many_graphs_come_as_often_as_weights_say) {
    for (unsigned seed = 100; seed < 180; ++seed) {
        const Rifs rifs = systems::digits_on_a_graph(seed);
        for (const std::vector<double>& weights :
             {systems::random_weights(rifs, seed), default_weights(rifs)}) {
            const systems::Fit fit = systems::fit_of_words(rifs, weights, 5, 50'000, seed);
            EXPECT_TRUE(fit.words.fits()) << "seed " << seed << ": " << fit.words.value;
            EXPECT_TRUE(fit.pairs.fits()) << "seed " << seed << ": " << fit.pairs.value;
            EXPECT_EQ(fit.outside, 0) << "seed " << seed;
        }
    }
}

}  // namespace
}  // namespace pxm::host
