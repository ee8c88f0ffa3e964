// Laws of host/render/native_numeric: what native renders compute with.
#include "host/render/native_numeric.hpp"

#include <gtest/gtest.h>

#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"

namespace pxm::test {
namespace {

using namespace host;

TEST(NativeNumeric, is_double_where_the_clear_kernels_meet_hulls) {
    const auto numeric = [](const std::string& text) { return native_numeric(compile_text(text)); };
    EXPECT_EQ(numeric(scene_of("menger")), Numeric::single);
    EXPECT_EQ(numeric(scene_of("menger", "covers: on")), Numeric::single);
    EXPECT_EQ(numeric(scene_of("menger", "volume: hull")), Numeric::double_);
    const std::string both =
        ifs("tetra") + ifs("menger") + "object a { ifs: tetra hull } object b { ifs: menger }";
    EXPECT_EQ(numeric(both), Numeric::single);  // the wide engine's, and double for what it leaves
}

}  // namespace
}  // namespace pxm::test
