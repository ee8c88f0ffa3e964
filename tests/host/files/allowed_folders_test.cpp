// Laws of where the files that a scene names may lie.
#include "host/files/allowed_folders.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "host/error.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host {
namespace {

namespace fs = std::filesystem;

/// scenes/ with a scene, a part below it and, beside it, what is none of its business.
class Folders : public testing::Test {
  protected:
    Folders() {
        for (const char* name : {"scenes", "scenes/parts", "scenes2", "other place"})
            fs::create_directory(folder.path(name));
        for (const char* name : {"scenes/a.pxm", "scenes/parts/b.pxm", "scenes2/c.pxm", "d.pxm"})
            folder.write(name, "");
    }
    [[nodiscard]] std::string refusal(const std::string& name,
                                      const std::vector<std::string>& allowed = {}) const {
        std::vector<std::string> places;
        for (const std::string& a : allowed) places.push_back(folder.path(a));
        return test::error_of([&] {
            const AllowedFolders folders(folder.path("scenes/a.pxm"), places);
            (void)folders.resolved(folder.path(name));
        });
    }
    [[nodiscard]] std::string outside(const std::string& name, const std::string& suggested) const {
        return fmt::format(
            "4: {}: lies outside the scene's folder; if you trust the scene, add --allow {}",
            folder.path(name), suggested);
    }
    [[nodiscard]] std::string place(const std::string& name = ".") const {
        return fs::canonical(folder.path(name)).string();
    }
    test::Folder folder;
};

TEST_F(Folders, what_lies_below_the_scene_may_be_read_and_nothing_else) {
    EXPECT_EQ(refusal("scenes/a.pxm"), "");
    EXPECT_EQ(refusal("scenes/parts/b.pxm"), "");
    EXPECT_EQ(refusal("scenes/parts/../a.pxm"), "");
    EXPECT_EQ(refusal("scenes/../d.pxm"), outside("scenes/../d.pxm", place()));
    EXPECT_EQ(refusal("/etc/passwd"),
              "4: /etc/passwd: lies outside the scene's folder; if you trust the scene, add "
              "--allow /etc");
}

TEST_F(Folders, a_longer_name_is_another_folder) {
    EXPECT_EQ(refusal("scenes2/c.pxm"), outside("scenes2/c.pxm", place("scenes2")));
}

TEST_F(Folders, more_may_be_allowed_and_what_lies_below) {
    EXPECT_EQ(refusal("scenes2/c.pxm", {"scenes2"}), "");
    EXPECT_EQ(refusal("scenes2/c.pxm", {"other place", "scenes2"}), "");
    EXPECT_EQ(refusal("scenes2/c.pxm", {""}), "");
    EXPECT_NE(refusal("d.pxm", {"scenes2"}), "");
}

TEST_F(Folders, a_link_is_where_it_leads_to) {
    fs::create_symlink("../d.pxm", folder.path("scenes/inner.pxm"));
    fs::create_directory_symlink("../scenes2", folder.path("scenes/inner"));
    fs::create_symlink("parts/b.pxm", folder.path("scenes/good.pxm"));
    fs::create_directory_symlink("scenes", folder.path("outer"));
    EXPECT_EQ(refusal("scenes/inner.pxm"), outside("scenes/inner.pxm", place()));
    EXPECT_EQ(refusal("scenes/inner/c.pxm"), outside("scenes/inner/c.pxm", place("scenes2")));
    EXPECT_EQ(refusal("scenes/good.pxm"), "");
    EXPECT_EQ(refusal("outer/a.pxm"), "");
    EXPECT_EQ(refusal("scenes/inner/c.pxm", {"scenes/inner"}), "");
}

TEST_F(Folders, whether_there_is_a_file_outside_is_not_told) {
    const std::string there = refusal("d.pxm");
    const std::string not_there = refusal("e.pxm");
    EXPECT_EQ(there.substr(there.find(": lies")), not_there.substr(not_there.find(": lies")));
    EXPECT_EQ(refusal("scenes/none.pxm"), "") << "inside it is for the reader to find out";
}

TEST_F(Folders, the_advice_is_one_word_of_a_command_line) {
    EXPECT_EQ(refusal("other place/x"),
              outside("other place/x", fmt::format("'{}'", place("other place"))));
    EXPECT_NE(refusal("it's $(x)/x").find(R"(it'\''s $(x)')"), std::string::npos);
}

TEST_F(Folders, only_a_folder_can_be_allowed) {
    for (const char* name : {"none", "d.pxm"})
        EXPECT_EQ(refusal("scenes/a.pxm", {name}),
                  fmt::format("2: --allow: found \"{}\", expected a folder", folder.path(name)));
}

TEST(AllowedFolders, text_in_memory_may_name_any_file) {
    EXPECT_EQ(AllowedFolders().resolved("/etc/hosts"), "/etc/hosts");
}

}  // namespace
}  // namespace pxm::host
