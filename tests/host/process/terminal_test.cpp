// Laws of what is printed: text from files and their names changes no terminal, no line and no
// file's head.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/text/printable.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

/// Everything that is done to a terminal: C0, DEL, C1, marks of direction, no UTF-8.
const std::string hostile = "\x1b]0;t\x07\x7f\xc2\x9b\xe2\x80\xae\xd8\x9c\xff";

/// Whether a terminal would show all of it as it is; lines may end.
bool is_harmless(const std::string& text) { return host::printable_lines(text) == text; }

class Printed : public testing::Test {
  protected:
    /// Expects that nothing hostile is printed, whatever the exit code.
    Outcome harmless(const Arguments& arguments) const {
        Outcome outcome = run(folder, arguments);
        EXPECT_TRUE(is_harmless(outcome.out)) << outcome.out;
        EXPECT_TRUE(is_harmless(outcome.err)) << outcome.err;
        return outcome;
    }
    Folder folder;
};

TEST(Printable, letters_of_all_scripts_stay_and_what_acts_goes) {
    const std::string text =
        "fa\xc3\xa7"
        "ade \xe5\x88\x86\xe5\xbd\xa2 \xf0\x9f\x8c\xbf";
    EXPECT_EQ(host::printable_path(text), text);
    EXPECT_EQ(host::printable_lines("a\n\tb" + text), "a\n\tb" + text);
    EXPECT_EQ(host::printable_path("a\nb\tc"), "a?b?c");
    EXPECT_FALSE(is_harmless(hostile));
    EXPECT_TRUE(is_harmless(host::printable_lines(hostile)));
    for (const char* mark : {"\xd8\x9c", "\xe2\x80\x8e", "\xe2\x80\xaa", "\xe2\x81\xa6",
                             "\xe2\x81\xa9", "\xe2\x80\xa8", "\xef\xbb\xbf", "\xf3\xa0\x80\x81"})
        EXPECT_EQ(host::printable_path(mark), std::string(std::string_view(mark).size(), '?'));
}

TEST_F(Printed, names_in_scenes_and_on_the_command_line_are_harmless) {
    const std::string name = hostile + ".pxm";
    folder.write(name, tetra_scene);
    EXPECT_EQ(harmless({"render", name, "--size", "8x8", "-o", hostile + ".png"}).exit_code, 0);
    EXPECT_EQ(harmless({"inspect", name}).exit_code, 0);
    EXPECT_EQ(harmless({"render", hostile + "x", "-o", "a.png"}).exit_code, 4);
    EXPECT_EQ(harmless({"render", name, "-o", hostile}).exit_code, 2);
    EXPECT_EQ(harmless({"render", name, "--volume", hostile}).exit_code, 2);
    EXPECT_EQ(harmless({hostile}).exit_code, 2);
    EXPECT_EQ(harmless({"compare", hostile, hostile}).exit_code, 4);
    EXPECT_EQ(harmless({"import", hostile}).exit_code, 4);
    folder.write("t.pxm", "texture t { file: \"" + hostile +
                              "x.png\" }\n"
                              "plane p { normal: 0,1,0 point: 0,-1,0 texture: t }\n");
    EXPECT_NE(harmless({"render", "t.pxm"}).exit_code, 0);
    folder.write("i.pxm", "include: \"" + hostile + ".pxm\"\ninclude: \"" + hostile + "\"");
    EXPECT_EQ(harmless({"render", "i.pxm"}).exit_code, 3);
}

TEST_F(Printed, names_that_are_no_text_are_no_trouble_in_json) {
    const std::string name = hostile + "\n.pxm";
    folder.write(name, tetra_scene);
    EXPECT_EQ(
        harmless({"render", name, "--size", "8x8", "-o", "a.png", "--stats", "a.json"}).exit_code,
        0);
    const std::string statistics = folder.read("a.json");
    EXPECT_TRUE(is_harmless(statistics));
    EXPECT_TRUE(nlohmann::json::accept(statistics));
    const Outcome inspected = harmless({"inspect", name, "--json"});
    EXPECT_EQ(inspected.exit_code, 0);
    EXPECT_TRUE(nlohmann::json::accept(inspected.out));
}

TEST_F(Printed, a_name_is_one_line_of_a_point_clouds_head) {
    const std::string name = "a\nend_header\n" + hostile + ".pxm";
    folder.write(name, tetra_scene);
    EXPECT_EQ(harmless({"points", name, "-n", "5", "-o", "a.ply"}).exit_code, 0);
    const std::string ply = folder.read("a.ply");
    const std::string head = ply.substr(0, ply.find("\nend_header\n"));
    EXPECT_TRUE(is_harmless(head)) << head;
    EXPECT_EQ(ply.size(), head.size() + std::string("\nend_header\n").size() + 5 * 15);
}

TEST_F(Printed, of_a_file_that_is_no_scene_no_word_is_shown) {
    folder.write("secret", "root:x:0:0:secret\n");
    folder.write("s.pxm", "include: \"secret\"\nifs a { newmap scale: 0.5 }\n");
    const Outcome outcome = harmless({"inspect", "s.pxm"});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.err,
              "pxm: s.pxm:1:10: error: \"secret\" is no scene: it begins with no block, let or "
              "include\n    include: \"secret\"\n             ^\n");
}

}  // namespace
}  // namespace pxm::test
