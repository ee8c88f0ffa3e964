// Laws of host/fractal/bounds/filled: which attractors fill what bounds them.
#include "host/fractal/bounds/filled.hpp"

#include <gtest/gtest.h>

#include "tests/host/fractal/systems.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/known_surface.hpp"

namespace pxm::test {
namespace {

using namespace host;

Filling filling_of(const std::string& maps) {
    const CompiledScene scene = compile_text("ifs it {\n" + maps + "}\n");
    const CompiledShape& shape = scene.shapes.front();
    Rifs rifs;
    for (const CompiledMap& map : shape.maps) {
        rifs.maps.push_back(map.map);
        rifs.follow_of.push_back(map.follow_set);
    }
    for (const CompiledSet& set : shape.sets) rifs.follow_sets.push_back({set.maps});
    rifs.start = shape.start;
    return find_filling(rifs).filling;
}

TEST(Filled, knows_solids_polygons_and_surfaces) {
    for (const KnownSurface& surface : known_surfaces()) {
        const Filling expected = surface.is_curved() ? Filling::surface
                                 : surface.graph     ? Filling::polygon
                                                     : Filling::solid;
        EXPECT_EQ(filling_of(surface.maps), expected) << surface.name;
    }
}

TEST(Filled, takes_none_of_the_fractals_for_one) {
    for (const auto& [name, rifs] : systems::thesis_systems()) {
        EXPECT_EQ(find_filling(rifs).filling, Filling::none) << name;
    }
}

/// Cantor's dust times squares, a square with a hole, one whose quarters are moved apart, or drawn
/// over each other: sizes that add up are not enough, nor is a hull that is covered.
TEST(Filled, leaves_what_has_gaps_or_sticks_out) {
    const auto squares = [](const std::string& last) {
        return "newmap scale: 1/2 newmap scale: 1/2 translate: 1/2,0,0 "
               "newmap scale: 1/2 translate: 0,1/2,0 newmap " +
               last;
    };
    EXPECT_EQ(filling_of(squares("scale: 1/2 translate: 1/2,1/2,0")), Filling::polygon);
    EXPECT_EQ(filling_of(squares("scale: 1/2 translate: 0.51,1/2,0")), Filling::none);
    EXPECT_EQ(filling_of(squares("scale: 1/2 translate: 1/2,0,0")), Filling::none);
    EXPECT_EQ(filling_of(squares("scale: 0.49 translate: 1/2,1/2,0")), Filling::none);
    EXPECT_EQ(filling_of(squares("scale: 1/2 rotate: z,45 translate: 1/2,1/2,0")), Filling::none);
}

}  // namespace
}  // namespace pxm::test
