// Systems whose maps have different ratios, and whose cells coincide: the same sets by other maps.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "tests/host/fractal/neighbours/findings_of.hpp"

namespace pxm::test {
namespace {

using host::ExactFindings;

constexpr double digits = 2e-6;

/// {x/3, (x+1)/3, (x+3)/3} with one map written as its products with all three: the same set, of
/// ratios 1/3 and 1/9 [NW01].
TEST(Ratios, a_map_that_is_written_as_its_products_changes_no_dimension) {
    const std::vector<std::string> third{"scale: 1/3", "scale: 1/3 translate: 1/3,0,0",
                                         "scale: 1/3 translate: 1,0,0"};
    for (std::size_t split = 0; split < 3; ++split) {
        std::vector<std::string> maps;
        for (std::size_t m = 0; m < 3; ++m) {
            if (m != split) {
                maps.push_back(third[m]);
                continue;
            }
            for (const std::string& inner : third) maps.push_back(inner + " " + third[m]);
        }
        const ExactFindings found = exact_of(system_of(maps));
        EXPECT_EQ(found.overlaps.value, true);
        ASSERT_TRUE(found.hausdorff.value) << found.hausdorff.why;
        EXPECT_NEAR(*found.hausdorff.value, 0.876036, digits) << found.hausdorff.why;
    }
}

/// The golden gasket [BMS04] with turned products, so that no map alone is the unit of ratios: its
/// second and third powers.
TEST(Ratios, squares_and_cubes_have_a_unit) {
    const std::vector<std::string> golden{
        "scale: 1/phi", "scale: 1/phi translate: 1-1/phi,0,0",
        "scale: 1/phi translate: (1-1/phi)/2,(1-1/phi)*sqrt(3)/2,0"};
    std::vector<std::string> maps;
    for (const std::string& outer : golden)
        for (const std::string& inner : golden) {
            const bool split = maps.empty();
            for (const std::string& innermost : golden)
                if (split) maps.push_back(innermost + " " + inner + " " + outer);
            if (!split) maps.push_back(inner + " " + outer);
        }
    const ExactFindings found = exact_of(system_of(maps));
    EXPECT_EQ(found.overlaps.value, true);
    ASSERT_TRUE(found.hausdorff.value) << found.hausdorff.why;
    EXPECT_NEAR(*found.hausdorff.value, 1.93063, 1e-5);
}

TEST(Ratios, powers_of_no_one_number_are_left_open) {
    const ExactFindings found = exact_of(system_of({"scale: 1/3", "scale: 1/4 translate: 3/4,0,0",
                                                    "scale: 1/3 scale: 1/4 translate: 3/4,0,0"}));
    EXPECT_EQ(found.overlaps.value, true);
    EXPECT_FALSE(found.hausdorff.value);
}

}  // namespace
}  // namespace pxm::test
