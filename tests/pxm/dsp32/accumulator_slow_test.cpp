// Many random instructions of the accumulator against the exact model.
#include "tests/pxm/dsp32/check_against_model.hpp"

namespace pxm::dsp32 {
namespace {

TEST(Dsp32AccumulatorSlow, ten_million_random_operations_agree_with_the_exact_model) {
    check_against_model(/*seed=*/1964, /*instructions=*/10'000'000);
}

}  // namespace
}  // namespace pxm::dsp32
