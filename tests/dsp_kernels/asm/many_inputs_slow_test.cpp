#include "tests/dsp_kernels/asm/many_inputs.hpp"

namespace pxm::kernels {
namespace {

INSTANTIATE_TEST_SUITE_P(Dsp32, AsmKernelsOnManyInputs, testing::Values(100'000),
                         [](const auto&) { return "a_hundred_thousand"; });

}  // namespace
}  // namespace pxm::kernels
