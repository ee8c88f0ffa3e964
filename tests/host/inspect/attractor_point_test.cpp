// Points to look at in deep zooms.
#include "host/inspect/attractor_point.hpp"

#include <gtest/gtest.h>

#include "host/error.hpp"
#include "host/scene/parse/parser.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

std::string point(const std::string& text, const std::vector<std::string>& word) {
    Diagnostics diagnostics;
    const Scene scene = parse_text("test.pxm", text, diagnostics);
    return attractor_point(scene, word);
}

std::string refused(const std::string& text, const std::vector<std::string>& word) {
    return error_of([&] { (void)point(text, word); });
}

constexpr const char* halves = R"(
ifs a { newmap here scale: 0.5 translate: 0,0.5,0  newmap there scale: 0.5 translate: 0.5,-0.25,0 }
)";

TEST(AttractorPoint, is_known_to_sixty_digits) {
    const std::string zeros(60, '0');
    EXPECT_EQ(point(halves, {"1"}), "0." + zeros + ",1." + zeros + ",0." + zeros);
    EXPECT_EQ(point(halves, {"here", "2", "there"}),
              "0.428571428571428571428571428571428571428571428571428571428571,"
              "0.357142857142857142857142857142857142857142857142857142857143,0." +
                  zeros);
}

TEST(AttractorPoint, is_where_the_object_is) {
    const std::string placed =
        std::string(halves) + "object o { ifs: a scale: 2 translate: 1,0,0 }";
    const std::string zeros(60, '0');
    EXPECT_EQ(point(placed, {"1"}), "1." + zeros + ",2." + zeros + ",0." + zeros);
}

TEST(AttractorPoint, may_lie_farther_away_than_whole_numbers_reach) {
    const std::string zeros(60, '0');
    EXPECT_EQ(
        point("ifs a { newmap scale: 0.5 translate: 1e20,-1e20,0 }", {"1"}),
        "200000000000000000000." + zeros + ",-200000000000000000000." + zeros + ",0." + zeros);
}

TEST(AttractorPoint, has_an_address) {
    EXPECT_EQ(refused(halves, {"3"}), "2: --point: ifs \"a\" has no map \"3\"");
    EXPECT_EQ(refused(ifs("asymmetric"), {"a", "d"}), "2: --point: map \"d\" may not come there");
    EXPECT_EQ(refused(ifs("asymmetric"), {"a", "b"}),
              "2: --point: map \"a\" may not come after the last one");
    EXPECT_EQ(refused("object o { volume: sphere }", {"1"}),
              "2: --point: no object of the scene has an ifs");
}

}  // namespace
}  // namespace pxm::test
