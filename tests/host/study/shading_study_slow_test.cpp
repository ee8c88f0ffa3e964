// Laws of `pxm study shading`.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using Json = nlohmann::ordered_json;

TEST(ShadingStudy, boxes_give_the_planes_normal_and_spheres_spread) {
    const Folder folder;
    expect_done(folder, {"study", "shading", "-o", "out", "--samples", "400", "--quiet"});
    const Json data = Json::parse(folder.read("out/data.json"));
    EXPECT_EQ(data["samples"], 400);
    EXPECT_EQ(data["weights"]["low-pass"]["thesis_sd"], 0.084);
    for (const Json& setup : data["setups"]) {
        for (const auto& [name, weight] : setup["weights"].items()) {
            EXPECT_EQ(weight["samples"], 400) << "every ray meets the plane";
            if (setup["volume"] == "boxes")
                EXPECT_LT(weight["sd"], 1e-6);
            else
                EXPECT_GT(weight["sd"], 1e-3);
        }
    }
    EXPECT_EQ(data["weights"]["constant"]["mode"], 1.0) << "as the thesis has it";
}

TEST(ShadingStudy, scenes_are_its_own) {
    const Folder folder;
    folder.write("tetra.pxm", tetra_scene);
    expect_refusal(folder, {"study", "shading", "tetra.pxm", "-o", "out"}, 2,
                   "study shading: it makes its own scenes (the extruded gasket), give it none");
}

}  // namespace
}  // namespace pxm::test
