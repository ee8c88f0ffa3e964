// `pxm inspect`: facts, keys, and what cannot be rendered yet.
#include "host/inspect/inspection.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host/inspect/inspect_json.hpp"
#include "host/inspect/inspect_text.hpp"
#include "tests/host/inspect/inspect_scene.hpp"
#include "tests/host/inspect/json_keys.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

using nlohmann::json;

const std::string two_parts =
    "ifs a { newmap stem scale: 0.5 newmap scale: 0.25 rotate: z,30 translate: 1,0,0\n"
    "        newmap scale: 0.5,0,0.5 newmap idle scale: 0.1 translate: 0,1,0\n"
    "        follow: stem -> stem, 2  follow: 2 -> 2, 3  follow: 3 -> 2, 3\n"
    "        follow: idle -> idle  start: stem }\n"
    "object shown { ifs: a sphere: (0,0,0) 0.5 }\n"
    "object ball { sphere }\n"
    "plane floor { normal: 0,1,0 }\n";

const json& two_parts_json() {
    static const json found = json::parse(host::inspect_json(inspect_text_of("a.pxm", two_parts)));
    return found;
}

TEST(Inspection, tells_kinds_graph_and_volumes) {
    const json& found = two_parts_json();
    expect_inspect_keys(found, "a.pxm");
    const json& a = found["ifs"]["a"];
    EXPECT_EQ(a["maps"][0]["kind"], "homothety");
    EXPECT_EQ(a["maps"][1]["kind"], "similitude");
    EXPECT_EQ(a["maps"][2]["kind"], "singular");
    EXPECT_TRUE(a["maps"][2]["condition"].is_null());
    EXPECT_EQ(a["maps"][1]["follow"], json::parse(R"(["2","3"])"));
    EXPECT_EQ(a["start"], json::parse(R"(["stem"])"));
    EXPECT_EQ(a["unreachable"], json::parse(R"(["idle"])"));
    EXPECT_EQ(a["dead_ends"], json::array());
    EXPECT_EQ(a["components"].size(), 3U);
    EXPECT_EQ(a["condensation"]["edges"].size(), 1U);  // from the stem to the pair
    EXPECT_GT(found["objects"][0]["short_by"], 0.1);
    EXPECT_EQ(found["objects"][0]["declared_volume"]["kind"], "sphere");
    EXPECT_EQ(found["objects"][1]["primitive"], true);
    EXPECT_EQ(found["objects"][1]["volume"], "sphere");
}

TEST(Inspection, tells_what_a_node_needs) {
    const json& found = two_parts_json();
    EXPECT_EQ(found["program"]["limit_bytes"], 36864);
    EXPECT_FALSE(found["program"]["modules"].empty());
    EXPECT_GT(found["program"]["modules"][0]["bytes"], 0);
    EXPECT_EQ(found["program"]["used_bytes"], found["memory"]["fast_memory"]["used_bytes"]);
    EXPECT_FALSE(found["program"]["left_out"].empty());
    EXPECT_GT(found["memory"]["back_buffer"]["used_bytes"], 0);
    EXPECT_EQ(found["memory"]["front_buffer"]["used_bytes"], 640 / 8 * 480 / 8 * 4);
}

TEST(Inspection, fixed_points_are_fixed) {
    const host::Inspection found = inspect_file(source_dir + "/scenes/tetra_exact.pxm");
    const host::IfsFacts& ifs = found.ifs.front();
    for (std::size_t m = 0; m < ifs.maps.size(); ++m) {
        const glm::dvec3 point = ifs.maps[m].fixed_point.value();
        EXPECT_LT(glm::distance(ifs.rifs.maps[m].point(point), point), 1e-12);
        EXPECT_NEAR(glm::length(point), 1, 1e-12);  // the vertices of the tetrahedron
    }
    EXPECT_NEAR(ifs.bounds[ifs.rifs.start].ball.radius, 1, 0.01);
}

TEST(Inspection, every_key_is_there_and_the_same_each_time) {
    const std::string path = source_dir + "/scenes/tetra.pxm";
    const std::string text = host::inspect_json(inspect_file(path));
    expect_inspect_keys(json::parse(text), path);
    EXPECT_EQ(text, host::inspect_json(inspect_file(path)));
}

TEST(Inspection, a_system_that_does_not_contract_is_a_mistake_of_the_scene) {
    host::Diagnostics diagnostics;
    const host::Scene scene =
        host::parse_text("b.pxm", "ifs b { newmap scale: 1.5 newmap scale: 0.5 }", diagnostics);
    (void)host::inspect(scene, "b.pxm", diagnostics);
    EXPECT_TRUE(diagnostics.has_errors());
    EXPECT_NE(diagnostics.text(scene.files).find("could not be shown to contract"),
              std::string::npos);
}

/// The block after the fence ```LANGUAGE.
std::string example(const std::string& document, const std::string& language) {
    const std::string fence = "```" + language + "\n";
    const std::size_t begin = document.find(fence) + fence.size();
    return document.substr(begin, document.find("```", begin) - begin);
}

TEST(Inspection, the_document_shows_what_is_printed) {
    std::ifstream file(source_dir + "/docs/inspect.md");
    std::stringstream document;
    document << file.rdbuf();
    const std::string scene = example(document.str(), "pxm");
    EXPECT_EQ(host::inspect_text(inspect_text_of("koch.pxm", scene)),
              example(document.str(), "text"));
}

}  // namespace
}  // namespace pxm::test
