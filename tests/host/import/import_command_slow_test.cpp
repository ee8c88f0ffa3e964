// `pxm import` as a user runs it: files, streams and exit codes.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

namespace pxm::host {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test.
class ImportCommand : public testing::Test {
  protected:
    /// The exit code; what was printed is in the files out and err.
    int run(const std::string& arguments) const {
        const std::string command = "cd " + folder_.string() + " && '" + pxm::test::binary + "' " +
                                    arguments + " >out 2>err";
        return WEXITSTATUS(std::system(command.c_str()));
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    [[nodiscard]] std::string text(const std::string& name) const {
        std::ostringstream all;
        all << std::ifstream(folder_ / name).rdbuf();
        return all.str();
    }

    test::Folder own_;
    fs::path folder_ = own_.path();
};

constexpr const char* two_entries = "a { .5 0 0 .5 0 0 1 } b { .5 0 0 .5 0 1 1 .5 0 0 .5 1 0 1 }";

TEST_F(ImportCommand, the_scene_is_named_after_the_entry) {
    write("f.ifs", two_entries);
    EXPECT_EQ(run("import f.ifs --entry b"), 0);
    EXPECT_EQ(text("err"), "b.pxm: 2 maps\n");
    EXPECT_EQ(text("b.pxm").substr(0, 17), "# b: entry \"b\" of");
}

TEST_F(ImportCommand, a_dash_prints_the_scene) {
    write("f.ifs", two_entries);
    EXPECT_EQ(run("import f.ifs --entry b -o -"), 0);
    EXPECT_EQ(text("err"), "");
    const std::string printed = text("out");
    EXPECT_EQ(run("import f.ifs --entry b -o c.pxm"), 0);
    EXPECT_EQ(text("c.pxm"), printed);
}

TEST_F(ImportCommand, exit_codes_are_those_of_the_document) {
    write("f.ifs", two_entries);
    write("grows.ifs", "a { 2 0 0 2 0 0 1 }");
    EXPECT_EQ(run("import f.ifs"), 2);
    EXPECT_EQ(text("err"), "pxm: f.ifs has 2 entries; choose one with --entry NAME:\n  a\n  b\n");
    EXPECT_EQ(run("import f.ifs --entry c"), 2);
    EXPECT_EQ(run("import grows.ifs"), 3);
    EXPECT_EQ(run("import none.ifs"), 4);
    EXPECT_EQ(run("import f.ifs --entry b -o none/x.pxm"), 4);
    EXPECT_FALSE(fs::exists(folder_ / "b.pxm"));
}

}  // namespace
}  // namespace pxm::host
