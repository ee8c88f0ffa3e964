// The accuracies of the routines over one mantissa of seventeen (routines_full_test.cpp: over all).
#include "tests/pxm/dsp32/sweep.hpp"

namespace pxm::dsp32::routines {
namespace {

TEST(Dsp32RoutinesSlow, the_stated_accuracies_hold_for_one_mantissa_of_seventeen) {
    sweep_mantissas(/*stride=*/17);
}

}  // namespace
}  // namespace pxm::dsp32::routines
