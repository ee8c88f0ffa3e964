// Every scene of scenes/ in parts: 1, 2, 7 and 64 of them, joined, are what one run writes, on the
// machine too. The pictures are small, as a scene's text decides about a part, not its pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::vector<std::string> all_scenes() {
    std::vector<std::string> scenes;
    const fs::path top = fs::path(source_dir) / "scenes";
    for (const auto& entry : fs::recursive_directory_iterator(top)) {
        const std::string path = entry.path().string();
        // What lies in parts/ is included by others and has no view of its own.
        if (path.ends_with(".pxm") && path.find("/parts/") == std::string::npos)
            scenes.push_back(fs::relative(path, top).string());
    }
    std::ranges::sort(scenes);
    return scenes;
}

class SceneInParts : public testing::TestWithParam<std::string> {
  protected:
    [[nodiscard]] Arguments render(const Arguments& options) const {
        const std::string scenes = (fs::path(source_dir) / "scenes").string();
        Arguments all{"render", scenes + "/" + GetParam(), "--allow", scenes, "--quiet"};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }
    [[nodiscard]] Json counts(const std::string& name) const {
        Json json = Json::parse(folder.read(name));
        for (const char* key : {"seconds", "threads", "threads_because"}) json.erase(key);
        return json;
    }
    void expect_same(const std::vector<int>& cuts, const Arguments& options) const {
        Arguments one = render(options);
        one.insert(one.end(), {"-o", "one.exr", "--stats", "one.json"});
        expect_done(folder, one);
        for (const int n : cuts) {
            fs::remove_all(folder.path("parts"));
            for (int i = n; i >= 1; --i) {
                Arguments part = render(options);
                part.insert(part.end(),
                            {"-o", "parts", "--part", std::to_string(i) + "/" + std::to_string(n)});
                expect_done(folder, part);
            }
            expect_done(folder,
                        {"join", "parts", "-o", "all.exr", "--stats", "all.json", "--quiet"});
            EXPECT_TRUE(folder.read("all.exr") == folder.read("one.exr")) << n;
            EXPECT_EQ(counts("all.json"), counts("one.json")) << n;
        }
    }
    Folder folder;
};

TEST_P(SceneInParts, is_the_same_natively) {
    const Arguments channels{"--aov", "Z,node,volumes,level,heap,alpha,object,word,N"};
    Arguments whole = channels, other = channels;
    whole.insert(whole.end(), {"--size", "40x28"});
    other.insert(other.end(), {"--size", "23x17", "--numeric", "double", "--samples", "2"});
    // A frame with an open shutter is not made in parts.
    if (GetParam().starts_with("animation/"))
        other.insert(other.end(), {"--set", "animation.shutter=0"});
    expect_same({1, 7, 64}, whole);
    expect_same({2}, other);
}

TEST_P(SceneInParts, is_the_same_on_the_machine) {
    expect_same({2}, {"--size", "24x16", "--machine", "964dX", "--aov",
                      "Z,node,cycles,volumes,level,heap,alpha,object,word,N"});
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneInParts, testing::ValuesIn(all_scenes()),
                         [](const testing::TestParamInfo<std::string>& of) {
                             std::string name = of.param.substr(0, of.param.size() - 4);
                             std::ranges::replace_if(
                                 name, [](char c) { return std::isalnum(c) == 0; }, '_');
                             return name;
                         });

TEST(ScenesInParts, crop_of_the_whole_is_the_render_of_the_crop) {
    const Folder folder;
    const std::string scene = (fs::path(source_dir) / "scenes/five_solids.pxm").string();
    for (const std::string crop : {"0,0,96,64", "13,7,90,41"}) {
        expect_done(folder, {"render", scene, "-o", "one.exr", "--size", "96x64", "--crop", crop});
        for (const char* part : {"1/3", "2/3", "3/3"})
            expect_done(folder, {"render", scene, "-o", "parts" + crop, "--size", "96x64", "--crop",
                                 crop, "--part", part});
        expect_done(folder, {"join", "parts" + crop, "-o", "joined.exr"});
        EXPECT_TRUE(folder.read("joined.exr") == folder.read("one.exr"));
    }
}

}  // namespace
}  // namespace pxm::test
