// Laws of the chaos game (Alg. 7.1).
#include "host/fractal/measure/chaos_game.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "host/compile/proven_rifs.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/dimension/default_weights.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::host {
namespace {

struct System {
    ProvenRifs proven;
    std::vector<glm::dvec4> colors;
};

System system_of(const std::string& text) {
    Diagnostics diagnostics;
    const Scene scene = parse_text("test.pxm", text, diagnostics);
    auto proven = prove_rifs(scene.ifs.at(0), diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.text(scene.files);
    System system{std::move(*proven), {}};
    for (const MapBlock& map : scene.ifs[0].maps) {
        system.colors.push_back(map.color.value_or(glm::dvec4{0.0}));
    }
    return system;
}

ChaosGame game_of(const System& system, std::vector<double> weights, std::uint64_t seed = 7) {
    return {system.proven.rifs, weights, system.colors, seed};
}

ChaosGame game_of(const System& system) {
    return game_of(system, default_weights(system.proven.rifs));
}

const char* const gasket =
    "ifs gasket { newmap scale: 0.5 newmap scale: 0.5 translate: 0.5,0,0"
    " newmap scale: 0.5 translate: 0,0.5,0 }";

// Maps 1 and 2 make a Cantor set along x; where 3 was chosen, only 4 and 5 may follow: a Cantor set
// along y, high up.
const char* const hierarchy =
    "ifs hierarchy { newmap scale: 1/3 newmap scale: 1/3 translate: 2/3,0,0"
    " newmap scale: 1/3 translate: 0,0,10"
    " newmap scale: 1/3 newmap scale: 1/3 translate: 0,2/3,0"
    " follow: 1 -> 3 follow: 2 -> 3 follow: 3 -> 4, 5 follow: 4 -> 4, 5 follow: 5 -> 4, 5"
    " start: 1, 2 }";

/// Whether a coordinate lies on the middle-thirds Cantor set, up to `depth` digits.
bool in_cantor_set(double x, int depth) {
    for (int i = 0; i < depth; ++i) {
        x *= 3;
        if (x > 1 + 1e-6 && x < 2 - 1e-6) return false;
        if (x >= 2 - 1e-6) x -= 2;
    }
    return true;
}

TEST(ChaosGame, points_of_the_gasket_lie_on_it) {
    ChaosGame game = game_of(system_of(gasket));
    for (int i = 0; i < 20000; ++i) {
        glm::dvec3 x = game.next().place;
        for (int level = 0; level < 20; ++level) {  // into the triangle again by an inverse map
            x *= 2;
            if (x.x >= 1) {
                x.x -= 1;
            } else if (x.y >= 1) {
                x.y -= 1;
            }
            ASSERT_LE(x.x + x.y, 1 + 1e-4);
        }
    }
}

TEST(ChaosGame, lower_levels_of_a_hierarchy_are_not_lost) {
    ChaosGame game = game_of(system_of(hierarchy));
    std::set<int> cells;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 x = game.next().place;  // w_a(w_3(y)): y of the Cantor set along y axis
        ASSERT_NEAR(x.z, 10.0 / 3, 1e-6);
        const double y = x.y * 9;
        ASSERT_TRUE(in_cantor_set(y, 8)) << y;
        cells.insert((x.x > 0.5 ? 100 : 0) + static_cast<int>(y * 9));
    }
    EXPECT_EQ(cells.size(), 8U);  // two by map 1 or 2, times four cells of the second level
}

TEST(ChaosGame, start_maps_alone_are_outermost) {
    const System system = system_of(
        "ifs pound { newmap scale: 0.5 translate: -1,0,0 newmap scale: 0.5 translate: 1,0,0"
        " follow: 1 -> 2 follow: 2 -> 1 start: 1 }");
    ChaosGame game = game_of(system);
    const double only = -2.0 / 3;  // the fixed point of map 2 then 1: x = -1 + (1 + x / 2) / 2
    for (int i = 0; i < 100; ++i) EXPECT_NEAR(game.next().place.x, only, 1e-9);
}

TEST(ChaosGame, what_the_walk_rarely_comes_to_has_points_of_the_attractor_too) {
    // Map 2 is drawn once in 10^6; what stands inside it, about (5,5,5), is far from the origin.
    const System system = system_of(
        "ifs rare { newmap scale: 0.5 newmap scale: 0.5 newmap scale: 0.1 translate: 4.5,4.5,4.5"
        " follow: 1 -> 1, 2 follow: 2 -> 3 follow: 3 -> 3 start: 1 }");
    ChaosGame game = game_of(system, {1, 1e-3, 1e-3});
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 x = game.next().place;
        if (x.x < 1e-9) continue;  // 1 nearly for ever
        // Else map 1 some times, then 2, then 3 for ever: 5 / 2^k.
        const double k = std::log2(5 / x.x);
        ASSERT_NEAR(k, std::round(k), 1e-6) << x.x;
    }
}

TEST(ChaosGame, maps_come_as_often_as_their_weights_say) {
    ChaosGame game = game_of(system_of(gasket), {1, 2, 5});
    std::map<int, int> count;
    constexpr int points = 80000;
    for (int i = 0; i < points; ++i) {
        const glm::dvec3 x = game.next().place;
        ++count[x.x > 0.5 ? 1 : x.y > 0.5 ? 2 : 0];
    }
    EXPECT_NEAR(count[0], points / 8.0, 5 * std::sqrt(points / 8.0));
    EXPECT_NEAR(count[1], points / 4.0, 5 * std::sqrt(points / 4.0));
    EXPECT_NEAR(count[2], points * 5 / 8.0, 5 * std::sqrt(points * 5 / 8.0));
}

TEST(ChaosGame, the_same_seed_gives_the_same_points_and_another_seed_others) {
    const System system = system_of(gasket);
    const auto weights = default_weights(system.proven.rifs);
    ChaosGame a = game_of(system, weights, 1);
    ChaosGame b = game_of(system, weights, 1);
    ChaosGame c = game_of(system, weights, 2);
    int same_as_c = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 x = a.next().place;
        ASSERT_EQ(x, b.next().place);
        if (x == c.next().place) ++same_as_c;
    }
    EXPECT_LT(same_as_c, 10);
}

TEST(ChaosGame, the_outermost_map_paints_first) {
    const System system = system_of(
        "ifs two { newmap scale: 0.5 color: 1,0,0,0.5 newmap scale: 0.5 translate: 0.5,0,0"
        " color: 0,1,0,1 follow: 1 -> 2 follow: 2 -> 2 start: 1 }");
    ChaosGame game = game_of(system);
    // Map 1 blends half of red in, map 2 inside it covers all with green.
    EXPECT_EQ(game.next().blend.of({0.9, 0.9, 0.9}), glm::dvec3(0, 1, 0));
}

TEST(ChaosGame, points_of_random_systems_lie_in_their_bounds) {
    std::uint64_t state = 12345;
    const auto uniform = [&state](double low, double high) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return low + (high - low) * static_cast<double>(state >> 11) * 0x1p-53;
    };
    for (int round = 0; round < 60; ++round) {
        std::string text = "ifs r {";
        const int maps = 2 + static_cast<int>(uniform(0, 6));
        for (int i = 0; i < maps; ++i) {
            text += " newmap scale: " + std::to_string(uniform(-0.9, 0.9)) + "," +
                    std::to_string(uniform(-0.9, 0.9)) + "," + std::to_string(uniform(0.1, 0.9)) +
                    " rotate: z," + std::to_string(uniform(0, 360)) +
                    " translate: " + std::to_string(uniform(-1, 1)) + "," +
                    std::to_string(uniform(-1, 1)) + ",0";
            text += " follow: " + std::to_string(i + 1) + " -> " + std::to_string(i + 1) + "," +
                    std::to_string(1 + static_cast<int>(uniform(0, maps)));
        }
        // follow rules stand after the maps
        std::string rules;
        for (std::size_t at; (at = text.find(" follow:")) != std::string::npos;) {
            const std::size_t end = std::min(text.find(" newmap", at), text.size());
            rules += text.substr(at, end - at);
            text.erase(at, end - at);
        }
        const System system = system_of(text + rules + " }");
        const Rifs& rifs = system.proven.rifs;
        const auto bounds = bound(rifs, system.proven.contraction);
        const Bounds& all = bounds[static_cast<std::size_t>(rifs.start)];
        ChaosGame game = game_of(system);
        const double margin = 1e-6 * (all.ball.radius + glm::length(all.ball.center));
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 x = game.next().place;
            ASSERT_LE(glm::distance(x, all.ball.center), all.ball.radius + margin) << text << rules;
        }
    }
}

}  // namespace
}  // namespace pxm::host
