// Laws of host/scene/diagnostics: whole texts.
#include "host/scene/diagnostics.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/error.hpp"

namespace pxm::host {
namespace {

std::string one_error(const std::string& text, const Position& position) {
    Diagnostics diagnostics;
    diagnostics.error(position, "wrong");
    return diagnostics.text({{"a.pxm", text}});
}

TEST(Diagnostics, an_error_shows_place_line_and_caret) {
    EXPECT_EQ(one_error("one\n  two three\n", {0, 2, 7}),
              "a.pxm:2:7: error: wrong\n"
              "    two three\n"
              "        ^");
}

TEST(Diagnostics, tabs_are_blanks_and_control_bytes_question_marks) {
    EXPECT_EQ(one_error("\t\ta\tb\x1b[31m\x93 c", {0, 1, 12}),
              "a.pxm:1:12: error: wrong\n"
              "    a b?[31m? c\n"
              "             ^");
}

TEST(Diagnostics, a_character_of_two_bytes_is_one_column_of_the_caret) {
    EXPECT_EQ(one_error("\"\xc3\xa4\" x", {0, 1, 6}),
              "a.pxm:1:6: error: wrong\n"
              "    \"\xc3\xa4\" x\n"
              "        ^");
}

TEST(Diagnostics, a_long_line_is_a_window_around_the_caret) {
    const std::string text = std::string(5000, 'a') + "X" + std::string(5000, 'b');
    EXPECT_EQ(one_error(text, {0, 1, 5001}), "a.pxm:1:5001: error: wrong\n    ..." +
                                                 std::string(60, 'a') + "X" + std::string(59, 'b') +
                                                 "...\n    " + std::string(63, ' ') + "^");
}

TEST(Diagnostics, a_place_outside_every_line_and_file_is_still_a_message) {
    EXPECT_EQ(one_error("one\n", {0, 99, 1}), "a.pxm:99:1: error: wrong");
    EXPECT_EQ(one_error("one\n", {0, 2, 1}), "a.pxm:2:1: error: wrong");
    EXPECT_EQ(one_error("one\n", {3, 1, 1}), "error: wrong");
    EXPECT_EQ(one_error("one\n", {0, 1, 400}), "a.pxm:1:400: error: wrong\n    one\n       ^");
    EXPECT_EQ(one_error("one\n", {0, -1, -5}), "a.pxm:-1:-5: error: wrong\n    one\n    ^");
}

TEST(Diagnostics, the_byte_order_mark_takes_no_column) {
    EXPECT_EQ(one_error("\xef\xbb\xbfone", {0, 1, 1}), "a.pxm:1:1: error: wrong\n    one\n    ^");
}

TEST(Diagnostics, at_most_twenty_errors_are_kept) {
    Diagnostics diagnostics;
    for (int i = 0; i < 20; ++i) diagnostics.error({}, fmt::format("e{}", i));
    EXPECT_TRUE(diagnostics.full());
    EXPECT_EQ(diagnostics.text({}).find("stopped"), std::string::npos);
    for (int i = 20; i < 30; ++i) diagnostics.error({}, fmt::format("e{}", i));
    const std::string text = diagnostics.text({});
    EXPECT_EQ(text.find("e20"), std::string::npos);
    EXPECT_TRUE(text.ends_with("error: e19\n... and more: stopped after 20 errors")) << text;
}

TEST(Diagnostics, warnings_alone_do_not_throw) {
    Diagnostics diagnostics;
    diagnostics.warning({0, 1, 1}, "odd");
    EXPECT_NO_THROW(diagnostics.throw_if_errors({}));
    EXPECT_EQ(diagnostics.warnings_text({{"a.pxm", "one"}}),
              "a.pxm:1:1: warning: odd\n    one\n    ^");
}

TEST(Diagnostics, what_is_thrown_has_errors_and_warnings_in_order_and_the_scene_exit_code) {
    Diagnostics diagnostics;
    diagnostics.warning({5, 1, 1}, "odd");
    diagnostics.error({5, 1, 1}, "wrong");
    try {
        diagnostics.throw_if_errors({});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        EXPECT_STREQ(error.what(), "warning: odd\nerror: wrong");
    }
    EXPECT_EQ(diagnostics.warnings_text({}), "warning: odd");
}

}  // namespace
}  // namespace pxm::host
