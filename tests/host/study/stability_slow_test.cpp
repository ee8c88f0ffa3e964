// Laws of `pxm study stability`: nothing fails silently.
#include <gtest/gtest.h>

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
    EXPECT_EQ(data["cases"].size(), 3 * host::stability_cases().size());
    int right = 0;
    for (const Json& one : data["cases"]) {
        EXPECT_NE(one["grade"], "silent") << one["name"] << " " << one["numeric"];
        right += one["grade"] == "right";
        if (one["family"] == "dead end") {
            EXPECT_EQ(one["exit_code"], 3);
        }
        if (one["family"] == "heap") {
            EXPECT_EQ(one["grade"], "right") << one["numeric"];
        }
    }
    EXPECT_GT(right, 60);
}

}  // namespace
}  // namespace pxm::test
