// Laws of what the wide engine leaves to the reference kernels.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/wide/tables/eligible.hpp"
#include "tests/support/compile_text.hpp"

namespace pxm::host::wide {
namespace {

std::string why_not_a_spiral(double ratio) {
    const CompiledScene scene = test::compile_text(
        fmt::format("ifs spiral {{ newmap scale: {} rotate: y,40 translate: 0,0.1,0\n"
                    "newmap scale: 0.3 translate: 0.6,0.2,0 }}\nrender {{ volume: sphere }}\n",
                    ratio));
    return why_not_wide(scene, Numeric::single);
}

TEST(WhyNotWide, tables_that_would_fill_the_memory_are_not_begun) {
    EXPECT_EQ(why_not_a_spiral(0.95), "");
    EXPECT_THAT(why_not_a_spiral(0.999), testing::HasSubstr("hardly contract"));
}

}  // namespace
}  // namespace pxm::host::wide
