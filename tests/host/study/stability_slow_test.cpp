// Laws of `pxm study stability`: nothing fails silently.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "host/study/stability_cases.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using Json = nlohmann::ordered_json;

TEST(StabilityStudy, nothing_fails_silently) {
    const Folder folder;
    expect_done(folder, {"study", "stability", "-o", "out", "--quiet"});
    const Json data = Json::parse(folder.read("out/data.json"));
    EXPECT_EQ(data["cases"].size(), 4 * host::stability_cases().size());
    int right = 0;
    std::map<std::string, Json> wide;
    std::map<std::string, std::pair<long, long>> alarmed;  // pixels, and those that are wrong
    for (const Json& one : data["cases"]) {
        EXPECT_NE(one["grade"], "silent") << one["name"] << " " << one["numeric"];
        right += one["grade"] == "right";
        if (one["family"] == "dead end" || one["family"] == "no such map") {
            EXPECT_EQ(one["exit_code"], 3);
        }
        if (one["numeric"] == "double" && one["family"] == "zoom") {
            EXPECT_EQ(one["wrong_share"], 0.0) << one["name"];
        }
        if (one["numeric"] == "wide") wide[one["name"]] = one;
        const Json of_alarms = one.value("alarmed", Json::object());
        for (const auto& [alarm, counts] : of_alarms.items()) {
            auto& [pixels, wrong] = alarmed[alarm + " in " + one["numeric"].get<std::string>()];
            pixels += counts["pixels"].get<long>();
            wrong += counts["wrong"].get<long>();
        }
        if (one["family"] == "heap") {
            EXPECT_EQ(one["grade"], "right") << one["numeric"];
        }
    }
    EXPECT_GT(right, 140);
    EXPECT_GE(alarmed.size(), 4U * 3);  // precision, floored and capped in every number type
    for (const auto& [alarm, counts] : alarmed) EXPECT_GE(2 * counts.second, counts.first) << alarm;
    EXPECT_EQ(wide["zoom 1e+06"]["engine"], "wide");
    EXPECT_EQ(wide["zoom 1e+06"]["grade"], "right") << "where float is not";
    EXPECT_EQ(wide["singular map 0"]["engine"], "heap") << "left to the reference kernels";
    EXPECT_EQ(wide["contraction 0.9999"]["alarms"]["capped"], 16 * 12);
}

}  // namespace
}  // namespace pxm::test
