// `pxm inspect` on every scene there is, at its limits, and the laws of dimensions on many systems.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/fractal/dimension/affinity.hpp"
#include "host/fractal/dimension/similarity.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "host/inspect/inspect_json.hpp"
#include "tests/host/fractal/systems.hpp"
#include "tests/host/inspect/inspect_scene.hpp"
#include "tests/host/inspect/json_keys.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using host::Affine;
using host::Rifs;

TEST(InspectionSlow, every_scene_has_every_key) {
    for (const auto& entry : fs::directory_iterator(fs::path(source_dir) / "scenes")) {
        if (entry.path().extension() != ".pxm") continue;
        const std::string path = entry.path().string();
        expect_inspect_keys(nlohmann::json::parse(host::inspect_json(inspect_file(path))), path);
    }
}

TEST(InspectionSlow, the_largest_system_is_inspected_or_says_which_limit_was_met) {
    std::string text = "ifs big {\n";
    for (int i = 0; i < 65'536; ++i) {
        text += "newmap scale: 0.9999,0.9,0.8 translate: " + std::to_string(i % 251) + "," +
                std::to_string(i % 241) + "," + std::to_string(i % 239) + "\n";
    }
    const auto found =
        nlohmann::json::parse(host::inspect_json(inspect_text_of("big.pxm", text + "}\n")));
    expect_inspect_keys(found, "big");
    const auto& big = found["ifs"]["big"];
    EXPECT_TRUE(big["maps"][0]["follow"].is_null());
    EXPECT_TRUE(big["dimension"]["box_counting"].is_null());
    EXPECT_NE(big["dimension"]["box_counting_method"].get<std::string>().find("limit"),
              std::string::npos);
    EXPECT_EQ(big["open_set_condition"], "fails");
}

Affine random_similitude(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    return host::systems::map({host::rotation(host::Axis::x, 180 * unit(random)),
                               host::rotation(host::Axis::y, 180 * unit(random)),
                               host::scaling(glm::dvec3{0.5 + 0.49 * unit(random)}),
                               host::translation({unit(random), unit(random), unit(random)})});
}

/// A random graph over the maps, each map with at least one follower.
std::vector<std::vector<int>> random_graph(std::size_t maps, std::mt19937_64& random) {
    std::vector<std::vector<int>> follow(maps);
    for (std::vector<int>& of_map : follow) {
        for (std::size_t j = 0; j < maps; ++j) {
            if (random() % 3 == 0) of_map.push_back(static_cast<int>(j));
        }
        if (of_map.empty()) of_map.push_back(static_cast<int>(random() % maps));
    }
    return follow;
}

TEST(InspectionSlow, a_map_more_that_may_follow_never_lowers_the_similarity_dimension) {
    for (unsigned seed = 0; seed < 2000; ++seed) {
        std::mt19937_64 random(seed);
        std::vector<Affine> maps;
        for (std::size_t n = 2 + random() % 20; n > 0; --n)
            maps.push_back(random_similitude(random));
        auto follow = random_graph(maps.size(), random);
        const double before =
            host::similarity_dimension(host::systems::with_graph(maps, follow))->middle();
        maps.push_back(random_similitude(random));
        for (std::vector<int>& of_map : follow) of_map.push_back(static_cast<int>(maps.size()) - 1);
        follow.push_back({0, static_cast<int>(maps.size()) - 1});
        const double after =
            host::similarity_dimension(host::systems::with_graph(maps, follow))->middle();
        EXPECT_GE(after, before - 1e-9 * (1 + before)) << "seed " << seed;
    }
}

TEST(InspectionSlow, affinity_of_similitudes_is_their_similarity_dimension) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937_64 random(seed);
        std::vector<Affine> maps;
        for (std::size_t n = 2 + random() % 8; n > 0; --n)
            maps.push_back(random_similitude(random));
        const Rifs rifs = host::systems::with_graph(maps, random_graph(maps.size(), random));
        const double similarity = host::similarity_dimension(rifs)->middle();
        const host::Affinity affinity = host::affinity_dimension(rifs);
        EXPECT_NEAR(affinity.value, similarity, 1e-9 * (1 + similarity)) << "seed " << seed;
        EXPECT_LE(similarity, affinity.upper) << "seed " << seed;
    }
}

TEST(InspectionSlow, the_upper_bound_is_above_the_closed_form_in_other_coordinates) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> unit(0.05, 0.7);
        std::vector<Affine> maps;
        for (std::size_t n = 2 + random() % 3; n > 0; --n) {
            maps.push_back(host::scaling({unit(random), unit(random), unit(random)}));
        }
        const double exact = host::affinity_dimension(host::systems::complete(maps)).value;
        const Affine change = host::systems::random_map(random, 1);
        for (Affine& map : maps) map = then(then(inverse(change), map), change);
        const host::Affinity found = host::affinity_dimension(host::systems::complete(maps));
        EXPECT_GE(found.upper, exact) << "seed " << seed;
        EXPECT_NEAR(found.value, exact, 0.3) << "seed " << seed;
    }
}

}  // namespace
}  // namespace pxm::test
