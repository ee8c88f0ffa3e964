// The scenes that come with pxm, through a picture and back.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

TEST(PictureScenesSlow, every_scene_comes_back_with_the_same_bytes) {
    const fs::path scenes = fs::path(source_dir) / "scenes";
    const Folder folder;
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(scenes)) {
        const std::string name = fs::relative(entry.path(), scenes).string();
        if (entry.path().extension() != ".pxm" || name.starts_with("parts/")) continue;
        SCOPED_TRACE(name);
        const Arguments options{"--size", "24x18", "--quiet"};
        Arguments first{"render",  entry.path().string(), "-o", "old.png",
                        "--allow", scenes.string()};
        first.insert(first.end(), options.begin(), options.end());
        expect_done(folder, first);
        expect_done(folder, {"render", "old.png", "-o", "new.png", "--quiet"});
        EXPECT_TRUE(folder.read("old.png") == folder.read("new.png"));
        expect_done(folder, {"inspect", "old.png", "--scene", "-o", "scene.txt"});
        EXPECT_TRUE(folder.read("scene.txt").starts_with(text_of(entry.path())));
        ++count;
    }
    EXPECT_GT(count, 30);
}

}  // namespace
}  // namespace pxm::test
