// Laws of --stats: the keys of the documentation, and numbers that agree with each other.
#include "host/output/statistics_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

namespace pxm::host {
namespace {

using Json = nlohmann::json;
using Keys = std::set<std::string>;

Statistics some_statistics() {
    Statistics s;
    s.scene = "a \"b\".pxm";
    s.engine = "native";
    s.numeric = "float";
    s.size = {16, 8};
    s.threads = 3;
    s.seconds = {1, 2, 3, 4, 0.5, 4.5, 15};
    s.rays.eye_rays = 128;
    s.rays.hits = 50;
    s.rays.volumes_tested = 999;
    s.rays.heap_overflows = 4;
    s.rays.capped_rays = 2;
    s.program.modules = {{"camera", "every pixel has an eye ray"}};
    s.program.left_out = {{"box", "no bounding box"}};
    return s;
}

Statistics machine_statistics() {
    Statistics s = some_statistics();
    s.engine = "machine";
    s.model = "964dX";
    s.machine.emplace();
    s.machine->back_buffer = {262'144, 1000};
    s.machine->nodes.resize(2);
    s.machine->nodes[0].cycles = 5'000'000;  // a second of 200 ns each
    s.machine->nodes[1].cycles = 10'000'000;
    s.machine->nodes[1].id = 1;
    s.machine->nodes[1].column = 1;
    return s;
}

Keys keys(const Json& json) {
    Keys all;
    for (const auto& [key, value] : json.items()) all.insert(key);
    return all;
}

void expect_keys(const Json& json, const Keys& documented) {
    const Keys there = keys(json);
    for (const std::string& key : documented) EXPECT_TRUE(there.contains(key)) << key;
}

const Keys on_both{"pxm",         "scene",          "engine",         "model",
                   "numeric",     "size",           "threads",        "seconds",
                   "rays",        "hits",           "volumes_tested", "heap_overflows",
                   "capped_rays", "threads_because"};

TEST(StatisticsJson, a_native_run_has_the_documented_keys) {
    const Json json = Json::parse(statistics_json(some_statistics()));
    expect_keys(json, on_both);
    for (const char* key : {"program", "memory", "nodes", "balance"}) {
        EXPECT_FALSE(json.contains(key)) << key;
    }
    EXPECT_EQ(keys(json["seconds"]),
              (Keys{"parse", "compile", "load", "render", "encode", "write", "total"}));
    EXPECT_EQ(keys(json["rays"]), (Keys{"eye", "light", "reflect"}));
    EXPECT_EQ(json["scene"], "a \"b\".pxm");
    EXPECT_EQ(json["size"], (Json{16, 8}));
    EXPECT_EQ(json["rays"]["eye"], 128);
    EXPECT_EQ(json["hits"], 50);
    EXPECT_EQ(json["volumes_tested"], 999);
    EXPECT_EQ(json["heap_overflows"], 4);
    EXPECT_EQ(json["capped_rays"], 2);
    EXPECT_EQ(json["seconds"]["compile"], 2);
    EXPECT_EQ(json["seconds"]["total"], 15);
}

TEST(StatisticsJson, a_machine_run_has_the_documented_keys) {
    const Json json = Json::parse(statistics_json(machine_statistics()));
    expect_keys(json, on_both);
    expect_keys(json, {"program", "memory", "nodes", "balance"});
    EXPECT_EQ(json["model"], "964dX");
    expect_keys(json["program"], {"limit_bytes", "used_bytes", "modules", "left_out"});
    EXPECT_EQ(json["program"]["limit_bytes"], 36'864);
    for (const char* list : {"modules", "left_out"}) {
        expect_keys(json["program"][list][0], {"name", "bytes", "because"});
    }
    expect_keys(json["memory"], {"zbuffer", "back_buffer", "texture"});
    for (const Json& memory : json["memory"]) expect_keys(memory, {"limit_bytes", "used_bytes"});
    EXPECT_EQ(json["memory"]["back_buffer"]["used_bytes"], 1000);
    expect_keys(json["nodes"][0],
                {"id", "column", "row", "pixels", "rays", "volumes_tested", "heap_pushes",
                 "heap_peak", "heap_overflows", "cycles", "seconds"});
    expect_keys(json["balance"], {"mean_cycles", "max_cycles", "efficiency", "predicted_seconds"});
}

TEST(StatisticsJson, balance_is_mean_over_slowest_and_time_that_of_the_slowest) {
    const Json balance = Json::parse(statistics_json(machine_statistics()))["balance"];
    EXPECT_EQ(balance["mean_cycles"], 7.5e6);
    EXPECT_EQ(balance["max_cycles"], 10'000'000);
    EXPECT_EQ(balance["efficiency"], 0.75);
    EXPECT_DOUBLE_EQ(balance["predicted_seconds"], 2);
}

TEST(StatisticsJson, nodes_without_work_are_balanced) {
    Statistics s = machine_statistics();
    for (NodeStatistics& node : s.machine->nodes) node.cycles = 0;
    const Json balance = Json::parse(statistics_json(s))["balance"];
    EXPECT_EQ(balance["efficiency"], 1);
    EXPECT_EQ(balance["predicted_seconds"], 0);
}

}  // namespace
}  // namespace pxm::host
