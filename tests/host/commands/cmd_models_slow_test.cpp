// Laws of `pxm models`, as its user sees it.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "pxm/model.hpp"
#include "tests/support/paths.hpp"

namespace pxm::host {
namespace {

/// What a run prints to stdout and stderr, then its exit code.
std::string run(const std::string& arguments) {
    const std::string command = "'" + test::binary + "' " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::string text;
    std::array<char, 4096> buffer{};
    while (const std::size_t got = fread(buffer.data(), 1, buffer.size(), pipe)) {
        text.append(buffer.data(), got);
    }
    const int status = pclose(pipe);
    return text + "exit " + std::to_string(WEXITSTATUS(status));
}

TEST(CmdModels, prints_every_number_with_its_mark) {
    EXPECT_EQ(run("models"),
              R"(model        array   nodes  natural raster  pixels/node
916        4 x 4 R    16 R   1024 x 1024 R      65536 D
920        5 x 4 R    20 R   1280 x 1024 R      65536 D
932        8 x 4 R    32 R   1024 x 1024 R      32768 D
940       10 x 4 R    40 R   1280 x 1024 R      32768 D
964        8 x 8 R    64 R   1280 x 1024 R      20480 D
964dX      8 x 8 S    64 S   1280 x 1024 R      20480 D

memory             bytes   every node's, in all models
fast memory      36864 S   program, constants, stack, order of the heap
front buffer    262144 D   the picture, 32 bits a pixel
back buffer     262144 D   the shape database
z-buffer        131072 A   entries of the heap
texture         131072 A   2-D textures

one instruction cycle: 200 ns D

S  seen in a source
D  derived from sources by arithmetic
R  recalled, no source seen
A  assumed for the emulation
exit 0)");
}

TEST(CmdModels, says_the_same_in_json) {
    const std::string text = run("models --json");
    ASSERT_TRUE(text.ends_with("exit 0")) << text;
    const auto json = nlohmann::json::parse(text.substr(0, text.rfind("exit 0")));
    ASSERT_EQ(json["models"].size(), models().size());
    for (std::size_t i = 0; i < models().size(); ++i) {
        const auto& model = json["models"][i];
        EXPECT_EQ(model["name"], models()[i].name);
        EXPECT_EQ(model["array"]["columns"], models()[i].columns);
        EXPECT_EQ(model["array"]["rows"], models()[i].rows);
        EXPECT_EQ(model["array"]["nodes"], models()[i].nodes());
        for (const char* part : {"array", "natural_raster", "pixels_per_node"}) {
            EXPECT_TRUE(json["marks"].contains(model[part]["mark"].get<std::string>()));
        }
    }
    std::int64_t bytes = 0;
    for (const auto& memory : json["memories"]) bytes += memory["bytes"].get<std::int64_t>();
    EXPECT_EQ(bytes, fast_memory_bytes + 3 * bank_bytes);
}

TEST(CmdModels, sends_a_token_round_the_torus) {
    EXPECT_EQ(run("models --token 920"),
              "920: the token visited 20 of 20 nodes over 23 links and was home after 24 "
              "supersteps\nexit 0");
}

TEST(CmdModels, an_unknown_model_is_refused) {
    EXPECT_EQ(run("models --token 965"),
              "pxm: --token: found \"965\", expected a model out of 916 920 932 940 964 964dX (did "
              "you mean '964'?)\n"
              "exit 2");
}

TEST(CmdModels, a_cost_model_is_read_before_anything_is_rendered) {
    EXPECT_EQ(run("render scene.pxm --machine 916 --cost-model /nowhere.json"),
              "pxm: /nowhere.json: no such file\nexit 4");
    EXPECT_EQ(run("render scene.pxm --cost-model /nowhere.json"),
              "pxm: --cost-model: cycles are counted on the machine only (--machine MODEL)\n"
              "exit 2");
}

}  // namespace
}  // namespace pxm::host
