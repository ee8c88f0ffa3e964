#include "host/fractal/system/rifs.hpp"
#include "host/compile/build_rifs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

MapReference number(long n, int line = 1) { return {n, {0, line, 3}}; }
MapReference name(const std::string& text, int line = 1) { return {text, {0, line, 3}}; }

/// An ifs of halving maps; empty names stand for maps known by number.
IfsBlock block_of(const std::vector<std::string>& names) {
    IfsBlock block;
    block.name = "test";
    for (const std::string& map_name : names) {
        MapBlock map;
        map.name = map_name;
        map.commands.push_back({ScaleCommand{glm::dvec3{0.5}}, {}});
        block.maps.push_back(map);
    }
    return block;
}

IfsBlock block_of(std::size_t count) { return block_of(std::vector<std::string>(count)); }

std::vector<int> followers(const Rifs& rifs, int map) {
    return rifs.follow_sets[rifs.follow_of[map]].maps;
}

std::vector<int> start_maps(const Rifs& rifs) { return rifs.follow_sets[rifs.start].maps; }

Rifs built(const IfsBlock& block) {
    Diagnostics diagnostics;
    Rifs rifs = build_rifs(block, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors());
    return rifs;
}

/// What building the block complains of, in a file of many empty lines.
std::string complaints(const IfsBlock& block) {
    Diagnostics diagnostics;
    static_cast<void>(build_rifs(block, diagnostics));
    return diagnostics.text({{"test.pxm", std::string(40, '\n')}});
}

TEST(Rifs, without_rules_every_map_may_follow_every_other) {
    const Rifs rifs = built(block_of(3));
    ASSERT_EQ(rifs.follow_sets.size(), 1u);
    EXPECT_THAT(followers(rifs, 1), ElementsAre(0, 1, 2));
    EXPECT_THAT(start_maps(rifs), ElementsAre(0, 1, 2));
    EXPECT_THAT(rifs.map_names, ElementsAre("1", "2", "3"));
}

TEST(Rifs, a_complete_graph_of_65536_maps_is_one_follow_set) {
    const Rifs rifs = built(block_of(65'536));
    EXPECT_EQ(rifs.follow_sets.size(), 1u);
    EXPECT_EQ(strong_components(rifs).size(), 1u);
}

TEST(Rifs, maps_with_equal_rules_share_a_follow_set) {
    IfsBlock block = block_of(4);
    block.follow = {{number(1), {number(2), number(3)}}, {number(4), {number(3), number(2)}}};
    const Rifs rifs = built(block);
    EXPECT_EQ(rifs.follow_of[0], rifs.follow_of[3]);
    EXPECT_EQ(rifs.follow_of[1], rifs.follow_of[2]);
    EXPECT_NE(rifs.follow_of[0], rifs.follow_of[1]);
}

TEST(Rifs, rules_given_several_times_for_a_map_are_united) {
    IfsBlock block = block_of({"a", "b", "c"});
    block.follow = {{name("a"), {name("c")}}, {name("a"), {number(2), name("c")}}};
    EXPECT_THAT(followers(built(block), 0), ElementsAre(1, 2));
}

TEST(Rifs, start_maps_are_the_components_that_nothing_enters) {
    // Descent goes 1 <-> 2, then to 3 -> 4 -> 4: only 1 and 2 may be outermost.
    IfsBlock block = block_of(4);
    block.follow = {{number(1), {number(2)}},
                    {number(2), {number(1), number(3)}},
                    {number(3), {number(4)}},
                    {number(4), {number(4)}}};
    const Rifs rifs = built(block);
    EXPECT_THAT(start_maps(rifs), ElementsAre(0, 1));
    EXPECT_THAT(strong_components(rifs),
                ElementsAre(ElementsAre(0, 1), ElementsAre(2), ElementsAre(3)));
}

TEST(Rifs, the_symmetric_pound_sign_starts_anywhere) {
    IfsBlock block = block_of(4);
    for (long m = 1; m <= 4; ++m) {
        FollowRule rule{number(m), {}};
        for (long n = 1; n <= 4; ++n) {
            if (n != m) rule.followers.push_back(number(n));
        }
        block.follow.push_back(rule);
    }
    const Rifs rifs = built(block);
    EXPECT_THAT(start_maps(rifs), ElementsAre(0, 1, 2, 3));
    EXPECT_EQ(strong_components(rifs).size(), 1u);
}

TEST(Rifs, a_chain_of_65536_maps_does_not_recurse) {
    constexpr long length = 65'536;
    IfsBlock block = block_of(length);
    for (long m = 1; m <= length; ++m) {
        block.follow.push_back({number(m), {number(std::min(m + 1, length))}});
    }
    const Rifs rifs = built(block);
    EXPECT_THAT(start_maps(rifs), ElementsAre(0));
    const auto components = strong_components(rifs);
    ASSERT_EQ(components.size(), 65'536u);
    for (int m = 0; m < length; ++m) ASSERT_EQ(components[m], std::vector<int>{m});
}

TEST(Rifs, edges_between_components_lead_from_earlier_to_later_ones) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Rifs rifs = systems::random_system(3 * seed, 0.5);
        const auto components = strong_components(rifs);
        std::vector<std::size_t> place(rifs.maps.size());
        for (std::size_t c = 0; c < components.size(); ++c) {
            for (const int m : components[c]) place[m] = c;
        }
        for (std::size_t m = 0; m < place.size(); ++m) {
            for (const int next : followers(rifs, static_cast<int>(m))) {
                EXPECT_LE(place[m], place[next]) << "seed " << 3 * seed;
            }
        }
    }
}

TEST(Rifs, an_explicit_start_wins_and_warns_of_maps_never_reached) {
    IfsBlock block = block_of({"a", "b", "c"});
    block.follow = {{name("a"), {name("a")}}, {name("b"), {name("a")}}, {name("c"), {name("c")}}};
    block.maps[2].position = {0, 7, 5};
    block.start = {name("b"), name("a"), name("b")};
    EXPECT_THAT(start_maps(built(block)), ElementsAre(0, 1));
    const std::string text = complaints(block);
    EXPECT_THAT(text, HasSubstr("test.pxm:7:5"));
    EXPECT_THAT(text, HasSubstr("map \"c\" of ifs \"test\" is not reached from its start maps"));
    EXPECT_THAT(text, testing::Not(HasSubstr("map \"a\"")));
}

TEST(Rifs, no_map_is_unreached_without_an_explicit_start) {
    IfsBlock block = block_of(3);
    block.follow = {{number(1), {number(1)}}, {number(2), {number(2)}}, {number(3), {number(1)}}};
    EXPECT_EQ(complaints(block), "");
}

TEST(Rifs, an_unknown_map_is_an_error_at_its_place) {
    IfsBlock block = block_of({"a", "b"});
    block.follow = {{name("a"), {name("stem", 4)}}, {number(0, 5), {name("a")}}};
    block.start = {number(3, 6)};
    const std::string text = complaints(block);
    EXPECT_THAT(text, HasSubstr("test.pxm:4:3"));
    EXPECT_THAT(text, HasSubstr("ifs \"test\" has no map \"stem\""));
    EXPECT_THAT(text, HasSubstr("test.pxm:5:3"));
    EXPECT_THAT(text, HasSubstr("ifs \"test\" has no map 0 (its maps are 1 to 2)"));
    EXPECT_THAT(text, HasSubstr("test.pxm:6:3"));
    EXPECT_THAT(text, HasSubstr("ifs \"test\" has no map 3 (its maps are 1 to 2)"));
}

TEST(Rifs, a_map_that_nothing_may_follow_is_an_error) {
    IfsBlock block = block_of({"a", "b"});
    block.follow = {{name("b", 9), {}}};
    const std::string text = complaints(block);
    EXPECT_THAT(text, HasSubstr("test.pxm:9:3"));
    EXPECT_THAT(text, HasSubstr("no map may follow map \"b\" of ifs \"test\""));
}

TEST(Rifs, an_ifs_without_maps_is_an_error) {
    IfsBlock block = block_of(0);
    block.position = {0, 2, 1};
    const std::string text = complaints(block);
    EXPECT_THAT(text, HasSubstr("test.pxm:2:1"));
    EXPECT_THAT(text, HasSubstr("ifs \"test\" has no maps"));
}

}  // namespace
}  // namespace pxm::host
