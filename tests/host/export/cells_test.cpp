// Laws of host/export/cells: which cells there are.
#include "host/export/cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/compiled/bounding_volume.hpp"
#include "host/math/lipschitz.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::test {
namespace {

using namespace host;

ExportedObject object_of(const Rifs& rifs) {
    ExportedObject object;
    object.rifs = rifs;
    for (std::size_t set = 0; set < rifs.follow_sets.size(); ++set) {
        object.meshes.push_back(mesh_of(box_volume({-1, -1, -1}, {1, 1, 1})));
        object.diameters.push_back(2 * std::sqrt(3.0));
    }
    object.colors.assign(rifs.maps.size(), glm::dvec4{0.0});
    return object;
}

/// All products of maps that may stand in one another, by recursion.
void list_cells(const Rifs& rifs, const Affine& place, int set, long levels,
                std::vector<Affine>& cells) {
    if (levels == 0) return cells.push_back(place);
    for (const int map : rifs.follow_sets[static_cast<std::size_t>(set)].maps) {
        const auto at = static_cast<std::size_t>(map);
        list_cells(rifs, then(rifs.maps[at], place), rifs.follow_of[at], levels - 1, cells);
    }
}

TEST(Cells, of_a_level_are_all_words_of_that_length_in_order) {
    for (const Rifs& rifs : {systems::tetra(), systems::pound_sign(), systems::grass()}) {
        ExportedObject object = object_of(rifs);
        object.instance = translation({3, 1, 4});
        for (const long levels : {0L, 1L, 3L}) {
            std::vector<Affine> expected;
            list_cells(rifs, object.instance, rifs.start, levels, expected);
            CellWalk walk(object, {levels, {}});
            for (const Affine& place : expected) {
                const Cell* cell = walk.next();
                ASSERT_NE(cell, nullptr);
                ASSERT_EQ(cell->place, place);
            }
            EXPECT_EQ(walk.next(), nullptr);
            EXPECT_EQ(cells_at(rifs, levels), static_cast<double>(expected.size()));
            ASSERT_TRUE(count_cells(object, {levels, {}}, expected.size()));
            EXPECT_EQ(object.cells(), expected.size());
            EXPECT_FALSE(count_cells(object, {levels, {}}, expected.size() - 1));
        }
    }
}

TEST(Cells, end_as_soon_as_they_are_short_enough) {
    for (const Rifs& rifs : {systems::tetra(), systems::icos()}) {
        const ExportedObject object = object_of(rifs);
        constexpr double length = 0.3;
        CellWalk walk(object, {{}, length});
        double sum = 0, longest = 0;
        while (const Cell* cell = walk.next()) {
            longest = std::max(longest,
                               singular_values(cell->place.linear).values[0] * object.diameters[0]);
            ++sum;
        }
        EXPECT_LE(longest, length);
        EXPECT_GT(longest, 0.2 * length);
        EXPECT_GT(sum, static_cast<double>(rifs.maps.size()));
    }
}

TEST(Cells, stop_at_the_levels_of_their_object) {
    ExportedObject object = object_of(systems::tetra());
    object.levels = 2;
    ASSERT_TRUE(count_cells(object, {5, {}}, 1000));
    EXPECT_EQ(object.cells(), 16U);
    ASSERT_TRUE(count_cells(object, {{}, 1e-9}, 1000));
    EXPECT_EQ(object.cells(), 16U);
}

TEST(Cells, are_sheared_only_where_their_axes_are_not_perpendicular) {
    const auto is_sheared = [](const Affine& map, const Affine& instance) {
        ExportedObject object = object_of(systems::complete({map, scaling({0.5, 0.5, 0.5})}));
        object.instance = instance;
        EXPECT_TRUE(count_cells(object, {3, {}}, 100));
        return object.sheared;
    };
    const Affine none;
    const Affine turned = rotation(Axis::z, 30);
    EXPECT_FALSE(is_sheared(scaling({0.5, 0.25, 0.1}), none));
    EXPECT_FALSE(is_sheared(then(scaling({0.5, 0.5, 0.5}), turned), none));
    EXPECT_FALSE(is_sheared(scaling({-0.5, 0.5, 0.5}), turned));
    EXPECT_TRUE(is_sheared(then(turned, scaling({0.5, 0.25, 0.1})), none));
    EXPECT_TRUE(is_sheared(then(scaling({0.5, 0.5, 0.5}), turned), scaling({1, 2, 1})));
    EXPECT_FALSE(is_sheared(scaling({0.5, 0, 0.5}), none));
}

TEST(Cells, take_their_colours_from_the_outermost_map_inward) {
    ExportedObject object = object_of(systems::complete(
        {scaling({0.5, 0.5, 0.5}), then(scaling({0.5, 0.5, 0.5}), translation({1, 0, 0}))}));
    object.color = {1, 0, 0};
    object.colors = {{0, 1, 0, 0.5}, {0, 0, 1, 1}};
    CellWalk walk(object, {2, {}});
    const glm::dvec3 expected[] = {{0.25, 0.75, 0}, {0, 0, 1}, {0, 0.5, 0.5}, {0, 0, 1}};
    for (const glm::dvec3& color : expected) {
        const Cell* cell = walk.next();
        ASSERT_NE(cell, nullptr);
        EXPECT_EQ(cell->color, color);
    }
}

}  // namespace
}  // namespace pxm::test
