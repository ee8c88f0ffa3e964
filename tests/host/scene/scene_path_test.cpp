// Laws of scenes by name: which file a name means, what it may include, and what is suggested where
// there is none.
#include "host/scene/scene_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A folder that one is in, and two where scenes are looked for.
class ScenePath : public testing::Test {
  protected:
    ScenePath() {
        for (const char* name : {"here", "first/deeper", "second"})
            fs::create_directories(folder.path(name));
        first = "PXM_SCENE_PATH=" + folder.path("first");
        both = "PXM_SCENE_PATH=:" + folder.path("first") + "::" + folder.path("second");
    }
    /// A scene with one system of that name.
    void scene(const std::string& place, const std::string& ifs) const {
        folder.write(place,
                     "ifs " + ifs + " { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 }\n");
    }
    /// What `pxm inspect NAME` says of it.
    [[nodiscard]] Outcome inspect(const std::string& name, const std::string& variable) const {
        return run(folder, {"inspect", name}, {variable});
    }
    void expect_system(const std::string& name, const std::string& ifs,
                       const std::string& variable) const {
        const Outcome told = inspect(name, variable);
        EXPECT_EQ(told.exit_code, 0) << told.err;
        EXPECT_THAT(told.out, HasSubstr("ifs " + ifs)) << name;
    }
    Folder folder;
    std::string first, both;
};

TEST_F(ScenePath, a_name_is_a_file_then_one_with_the_ending_then_one_of_the_folders_in_order) {
    scene("second/sponge.pxm", "of_second");
    expect_system("sponge", "of_second", both);
    scene("first/sponge.pxm", "of_first");
    expect_system("sponge", "of_first", both);
    expect_system("sponge.pxm", "of_first", both);
    scene("sponge.pxm", "beside");
    expect_system("sponge", "beside", both);
    scene("sponge", "itself");
    expect_system("sponge", "itself", both);
}

TEST_F(ScenePath, scenes_that_come_with_pxm_are_found_last) {
    expect_system("menger", "menger", both);
    scene("first/menger.pxm", "mine");
    expect_system("menger", "mine", both);
}

TEST_F(ScenePath, a_folder_in_a_folder_is_part_of_the_name) {
    scene("first/deeper/a.pxm", "deep");
    expect_system("deeper/a", "deep", first);
}

TEST_F(ScenePath, a_path_that_goes_up_or_begins_at_the_root_is_no_name) {
    scene("first/a.pxm", "a");
    for (const std::string name : {"../first/a", "deeper/../../first/a", "/a", "./../first/a"}) {
        const Outcome told =
            run(folder, {"inspect", name}, {"PXM_SCENE_PATH=" + folder.path("second")});
        EXPECT_EQ(told.exit_code, 4) << name;
        EXPECT_THAT(told.err, HasSubstr("pxm: " + name + ": no such file"));
    }
}

TEST_F(ScenePath, every_command_that_reads_scenes_takes_names) {
    scene("first/grain.pxm", "grain");
    const Arguments commands[] = {{"check", "grain"},
                                  {"inspect", "grain"},
                                  {"points", "grain", "-n", "10", "-o", "a.ply", "--quiet"},
                                  {"render", "grain", "--size", "8x8", "--quiet"}};
    for (const Arguments& arguments : commands) {
        const Outcome told = run(folder, arguments, {first});
        EXPECT_EQ(told.exit_code, 0) << arguments[0] << ": " << told.err;
    }
    EXPECT_TRUE(folder.has("grain.png")) << "a picture has the scene's name, where one is";
    EXPECT_FALSE(folder.has("first/grain.png"));
}

TEST_F(ScenePath, a_scene_that_is_not_there_is_code_4_with_the_nearest_name) {
    scene("first/hexagons.pxm", "a");
    scene("here/pine_cone.pxm", "a");
    const auto told = [&](const std::string& name, const std::string& message) {
        const Outcome outcome = inspect(name, first);
        EXPECT_EQ(outcome.exit_code, 4);
        EXPECT_EQ(outcome.err, "pxm: " + message + "\n");
        EXPECT_EQ(outcome.out, "");
    };
    told("hexagnos", "hexagnos: no such file (did you mean 'hexagons'?)");
    told("hexagnos.pxm", "hexagnos.pxm: no such file (did you mean 'hexagons'?)");
    told("terta", "terta: no such file (did you mean 'tetra'?)");
    told("here/pine_cole.pxm",
         "here/pine_cole.pxm: no such file (did you mean 'here/pine_cone.pxm'?)");
    told("nothing_like_it", "nothing_like_it: no such file");
    const Outcome checked = run(folder, {"check", "hexagnos", "hexagons"}, {first});
    EXPECT_EQ(checked.exit_code, 4);
    EXPECT_EQ(checked.err, "hexagnos: no such file (did you mean 'hexagons'?)\n");
}

TEST_F(ScenePath, what_is_included_is_looked_for_beside_the_scene_and_then_by_name) {
    folder.write("main.pxm", "include: \"deeper/part.pxm\"\n");
    scene("first/deeper/part.pxm", "of_first");
    expect_system("main.pxm", "of_first", first);
    fs::create_directories(folder.path("deeper"));
    scene("deeper/part.pxm", "beside");
    expect_system("main.pxm", "beside", first);
}

TEST_F(ScenePath, what_was_found_by_name_may_include_files_of_its_folder) {
    scene("first/leaf.pxm", "leaf");
    folder.write("first/deeper/tree.pxm", "include: \"../leaf.pxm\"\n");
    folder.write("main.pxm", "include: \"deeper/tree.pxm\"\n");
    expect_system("main.pxm", "leaf", first);
    expect_system("deeper/tree", "leaf", first);
    const Outcome by_path = run(folder, {"inspect", "first/deeper/tree.pxm"}, {first});
    EXPECT_EQ(by_path.exit_code, 3) << "a path trusts its own folder alone";
    EXPECT_THAT(by_path.err, HasSubstr("lies outside the scene's folder"));
}

TEST_F(ScenePath, the_exhibitions_that_come_with_pxm_are_found_with_their_parts) {
    const Outcome told = run(folder, {"check", "exhibition/five_solids"}, {});
    EXPECT_EQ(told.exit_code, 0) << told.err;
}

TEST_F(ScenePath, no_include_leaves_the_folders_where_scenes_are_looked_for) {
    scene("here/secret.pxm", "secret");
    fs::create_symlink(folder.path("here"), folder.path("first/link"));
    for (const char* written :
         {"../here/secret.pxm", "link/secret.pxm", "deeper/../../here/secret.pxm"}) {
        folder.write("second/main.pxm", std::string("include: \"") + written + "\"\n");
        const Outcome told = run(folder, {"inspect", "second/main.pxm"}, {first});
        EXPECT_EQ(told.exit_code, 3) << written;
        EXPECT_THAT(told.out, Not(HasSubstr("secret"))) << written;
    }
}

TEST_F(ScenePath, all_scenes_have_names) {
    scene("first/deeper/a.pxm", "a");
    folder.write("first/readme.txt", "no scene");
    setenv("PXM_SCENE_PATH", folder.path("first").c_str(), 1);
    const std::vector<std::string> names = host::scene_names();
    unsetenv("PXM_SCENE_PATH");
    EXPECT_THAT(names, Contains("deeper/a"));
    EXPECT_THAT(names, Contains("tetra"));
    EXPECT_THAT(names, Contains("animation/zoom"));
    EXPECT_THAT(names, Not(Contains(HasSubstr("readme"))));
}

}  // namespace
}  // namespace pxm::test
