// The accuracies of the routines over every mantissa.
#include "tests/pxm/dsp32/sweep.hpp"

namespace pxm::dsp32::routines {
namespace {

TEST(Dsp32RoutinesFull, the_stated_accuracies_hold_for_every_mantissa) {
    sweep_mantissas(/*stride=*/1);
}

}  // namespace
}  // namespace pxm::dsp32::routines
