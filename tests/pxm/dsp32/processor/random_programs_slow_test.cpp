// The laws of random programs on a hundred times as many.
#include "tests/pxm/dsp32/processor/random_programs.hpp"

namespace pxm::dsp32::processor {
namespace {

TEST(Processor, many_random_programs_never_leave_the_node_and_never_hang) {
    try_random_programs(19, 200'000);
}
TEST(Processor, many_runs_to_breakpoints_are_that_many_single_steps) {
    EXPECT_GT(try_breakpoints(20, 10'000), 400);
}

}  // namespace
}  // namespace pxm::dsp32::processor
