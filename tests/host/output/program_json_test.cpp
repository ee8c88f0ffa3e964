// Laws of host/output/program_json.
#include "host/output/program_json.hpp"

#include <gtest/gtest.h>

namespace pxm::host {
namespace {

TEST(ProgramJson, says_everything_the_linker_says) {
    NodeProgram program;
    program.modules = {{"intersect", "ifs objects", 700}, {"box", "bounding boxes", 900}};
    program.left_out = {{"sphere", "no bounding sphere", 300}};
    program.stack_bytes = 50;
    program.deepest_calls = {"pixel_program", "intersect"};
    program.heap_order_bytes = 8;
    EXPECT_EQ(program_json(program).dump(),
              R"({"limit_bytes":36864,"used_bytes":1658,"modules_bytes":1600,"heap_order_bytes":8,)"
              R"("stack_bytes":50,"deepest_calls":["pixel_program","intersect"],)"
              R"("modules":[{"name":"intersect","bytes":700,"because":"ifs objects"},)"
              R"({"name":"box","bytes":900,"because":"bounding boxes"}],)"
              R"("left_out":[{"name":"sphere","bytes":300,"because":"no bounding sphere"}]})");
}

}  // namespace
}  // namespace pxm::host
