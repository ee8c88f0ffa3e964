// The laws of host/studio/scene_folder.hpp: nothing outside of the folder is read or written.
#include "host/studio/scene_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host/error.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

/// What the folder says of a name; empty if it opens it.
std::string refusal_of(const SceneFolder& folder, const std::string& name) {
    try {
        (void)folder.open(name);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

class SceneFolderTest : public testing::Test {
  protected:
    SceneFolderTest() {
        outside_.write("secret.pxm", "secret");
        fs::create_directories(inside_.path("deep/er"));
        inside_.write("a.pxm", "ifs a { newmap scale: 0.5 }\n");
        inside_.write("deep/er/b.pxm", "b");
        inside_.write("note.txt", "note");
        inside_.write(".hidden.pxm", "hidden");
        fs::create_symlink(outside_.path("secret.pxm"), inside_.path("link.pxm"));
        fs::create_directory_symlink(outside_.path(), inside_.path("away"));
    }
    test::Folder outside_;
    test::Folder inside_;
};

TEST_F(SceneFolderTest, lists_scenes_and_nothing_else) {
    EXPECT_THAT(SceneFolder(inside_.path()).scenes(), ElementsAre("a.pxm", "deep/er/b.pxm"));
}

TEST_F(SceneFolderTest, opens_what_lies_below_it) {
    const SceneFolder folder(inside_.path());
    EXPECT_EQ(folder.open("a.pxm").text, "ifs a { newmap scale: 0.5 }\n");
    EXPECT_EQ(folder.open("deep/er/b.pxm").text, "b");
}

TEST_F(SceneFolderTest, opens_nothing_else) {
    const SceneFolder folder(inside_.path());
    const std::string above = "../" + fs::path(outside_.path()).filename().string();
    for (const std::string& name : {std::string(),
                                    std::string("/etc/passwd"),
                                    outside_.path("secret.pxm"),
                                    above + "/secret.pxm",
                                    std::string("deep/../../x.pxm"),
                                    std::string("./a.pxm"),
                                    std::string("deep//er/b.pxm"),
                                    std::string("a.pxm/"),
                                    std::string("note.txt"),
                                    std::string(".hidden.pxm"),
                                    std::string("link.pxm"),
                                    std::string("away/secret.pxm"),
                                    std::string("deep"),
                                    std::string("deep\\a.pxm"),
                                    std::string("a.pxm\0.pxm", 10),
                                    std::string("a\n.pxm"),
                                    std::string("gone.pxm"),
                                    std::string(300, 'a') + ".pxm",
                                    std::string("%2e%2e/a.pxm"),
                                    std::string("..")}) {
        const std::string refusal = refusal_of(folder, name);
        EXPECT_NE(refusal, "") << name;
        EXPECT_EQ(refusal.find("secret\n"), std::string::npos) << name;
    }
}

TEST_F(SceneFolderTest, saves_what_it_has_seen) {
    const SceneFolder folder(inside_.path());
    const std::string seen = folder.open("a.pxm").digest;
    EXPECT_EQ(folder.save("a.pxm", "mine", seen), Saved::done);
    EXPECT_EQ(inside_.read("a.pxm"), "mine");
    inside_.write("a.pxm", "theirs");
    EXPECT_EQ(folder.save("a.pxm", "mine again", seen), Saved::changed);
    EXPECT_EQ(folder.save("a.pxm", "mine again", ""), Saved::changed) << "a new scene's name";
    EXPECT_EQ(inside_.read("a.pxm"), "theirs");
    EXPECT_EQ(folder.save("a.pxm", "mine again", folder.open("a.pxm").digest), Saved::done);
    EXPECT_EQ(folder.save("new.pxm", "new", ""), Saved::done);
    EXPECT_EQ(folder.save("gone.pxm", "x", seen), Saved::changed) << "somebody has removed it";
}

TEST_F(SceneFolderTest, saves_nothing_through_a_link_or_outside) {
    const SceneFolder folder(inside_.path());
    for (const char* name :
         {"link.pxm", "away/secret.pxm", "away/new.pxm", "../new.pxm", "nowhere/new.pxm", "x.txt"})
        EXPECT_THROW((void)folder.save(name, "x", ""), Error) << name;
    EXPECT_EQ(outside_.read("secret.pxm"), "secret");
    EXPECT_EQ(outside_.names().size(), 1U);
}

TEST_F(SceneFolderTest, opens_no_scene_that_is_very_large) {
    inside_.write("large.pxm", std::string(SceneFolder::scene_bytes + 1, '#'));
    EXPECT_NE(refusal_of(SceneFolder(inside_.path()), "large.pxm"), "");
}

}  // namespace
}  // namespace pxm::host
