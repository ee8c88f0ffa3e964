// Laws of `pxm study error`.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using Json = nlohmann::ordered_json;

class ErrorStudy : public testing::Test {
  protected:
    ErrorStudy() {
        folder.write("tetra.pxm", tetra_scene);
        folder.write("shear.pxm",
                     "ifs s { newmap matrix: 0.5,0.2,0, 0,0.5,0, 0,0,0.5, 0,0,0\n"
                     "newmap scale: 0.5 translate: 1,0,0 }");
        expect_done(folder, {"study", "error", "tetra.pxm", "-o", "out", "--size", "48x40",
                             "--repeats", "1", "--target", "1", "--budget", "1e-9", "--quiet"});
        data = Json::parse(folder.read("out/data.json"));
        scene = data["scenes"][0];
        for (const Json& point : scene["points"]) points[point["settings"]["name"]] = point;
    }
    Folder folder;
    Json data;
    Json scene;
    std::map<std::string, Json> points;
};

TEST_F(ErrorStudy, more_samples_and_finer_cells_come_nearer_to_the_reference) {
    const auto rmse = [&](const char* name) { return points.at(name)["rmse"].get<double>(); };
    EXPECT_LT(rmse("--samples 16"), rmse("--samples 4"));
    EXPECT_LT(rmse("--samples 4"), rmse("default"));
    const auto depth = [&](const char* name) {
        return points.at(name)["depth_error_pixels"].get<double>();
    };
    EXPECT_LT(depth("--detail 0.25"), depth("default"));
    EXPECT_LT(depth("default"), depth("--detail 4"));
}

TEST_F(ErrorStudy, a_small_heap_costs_time_and_no_error) {
    for (const char* heap : {"--heap 1", "--heap 16"}) {
        EXPECT_EQ(points.at(heap)["rmse"], points.at("default")["rmse"]) << heap;
        EXPECT_EQ(points.at(heap)["wrong_hits"], points.at("default")["wrong_hits"]) << heap;
    }
    EXPECT_GT(points.at("--heap 1")["machine_seconds"], points.at("default")["machine_seconds"]);
}

TEST_F(ErrorStudy, the_wide_engine_is_no_program_of_the_machine) {
    const Json& wide = points.at("--numeric float --intersect wide");
    EXPECT_TRUE(wide["machine_seconds"].is_null());
    EXPECT_FALSE(wide["pareto"].get<bool>());
    EXPECT_NEAR(wide["rmse"], points.at("--numeric float")["rmse"], 0.01);
}

TEST_F(ErrorStudy, no_point_of_the_front_is_beaten) {
    int front = 0;
    for (const auto& [name, point] : points) {
        if (point["machine_seconds"].is_null()) continue;
        front += point["pareto"].get<bool>();
        EXPECT_EQ(point["pareto"].get<bool>(), point["dominated_by"].is_null()) << name;
        for (const auto& [other, beaten] : points) {
            if (!beaten["pareto"].get<bool>()) continue;
            EXPECT_FALSE(point["machine_seconds"] < beaten["machine_seconds"] &&
                         point["rmse"] < beaten["rmse"])
                << name << " beats " << other;
        }
    }
    EXPECT_GE(front, 2);
}

TEST_F(ErrorStudy, a_setting_that_the_scene_does_not_allow_is_no_point_and_says_why) {
    EXPECT_TRUE(scene["refused"].empty()) << "homotheties in spheres";
    expect_done(folder, {"study", "error", "shear.pxm", "-o", "sheared", "--size", "8x8",
                         "--repeats", "1", "--quiet"});
    const Json sheared = Json::parse(folder.read("sheared/data.json"))["scenes"][0];
    ASSERT_EQ(sheared["refused"].size(), 1U);
    EXPECT_EQ(sheared["refused"][0]["settings"]["name"], "--volume sphere --intersect fast");
    EXPECT_NE(sheared["refused"][0]["refused"].get<std::string>().find("fast"), std::string::npos);
    EXPECT_EQ(sheared["points"].size() + 1, scene["points"].size());
}

TEST_F(ErrorStudy, budget_and_target_choose) {
    EXPECT_TRUE(scene["budget"]["settings"].is_null()) << "nothing takes a nanosecond";
    EXPECT_TRUE(scene["target"]["settings"].is_string()) << "everything is within an RMSE of 1";
    EXPECT_NE(scene["advice"].get<std::string>().find("for this scene: "), std::string::npos);
}

}  // namespace
}  // namespace pxm::test
