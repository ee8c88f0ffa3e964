// What the parser says to typical mistakes: whole texts.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/host/scene/scene_text.hpp"

namespace pxm::host {
namespace {

using test::parse_messages;

TEST(ParserErrors, a_misspelt_directive_is_told_the_nearest) {
    EXPECT_EQ(parse_messages("ifs a {\n  newmap\n  scael: 0.5\n}"),
              "s.pxm:3:3: error: unknown directive 'scael' in 'ifs' (did you mean 'scale'?)\n"
              "    scael: 0.5\n"
              "    ^");
}

TEST(ParserErrors, an_unknown_directive_is_told_what_there_is) {
    EXPECT_EQ(parse_messages("camera { wide: 3 }"),
              "s.pxm:1:10: error: unknown directive 'wide' in 'camera' "
              "(it takes eye, look, up, fov, orthographic, zoom)\n"
              "    camera { wide: 3 }\n"
              "             ^");
}

TEST(ParserErrors, a_misspelt_block_is_told_the_nearest) {
    EXPECT_EQ(parse_messages("objct a { cone }\nifs b { newmap }"),
              "s.pxm:1:1: error: expected a block, found 'objct' (did you mean 'object'?)\n"
              "    objct a { cone }\n"
              "    ^");
    EXPECT_EQ(
        parse_messages("42"),
        "s.pxm:1:1: error: expected a block, found '42' "
        "(ifs, object, plane, texture, light, camera, image, render, animation, let or include)\n"
        "    42\n"
        "    ^");
}

TEST(ParserErrors, a_missing_colon) {
    EXPECT_EQ(parse_messages("camera { fov 40 }"),
              "s.pxm:1:14: error: expected ':', found '40' (before the values of 'fov')\n"
              "    camera { fov 40 }\n"
              "                 ^");
    EXPECT_EQ(parse_messages("object a { ifs grass }"),
              "s.pxm:1:16: error: expected ':', found 'grass' (before the values of 'ifs')\n"
              "    object a { ifs grass }\n"
              "                   ^");
}

TEST(ParserErrors, a_missing_value) {
    EXPECT_EQ(parse_messages("camera { fov: }"),
              "s.pxm:1:15: error: expected a number, found '}'\n"
              "    camera { fov: }\n"
              "                  ^");
}

TEST(ParserErrors, too_few_and_too_many_values) {
    EXPECT_EQ(parse_messages("ifs a { newmap translate: 1,2 }"),
              "s.pxm:1:31: error: expected ',', found '}' ('translate' takes x,y,z)\n"
              "    ifs a { newmap translate: 1,2 }\n"
              "                                  ^");
    EXPECT_EQ(parse_messages("ifs a { newmap color: 1,1,1,1,1 }"),
              "s.pxm:1:30: error: one value too many (this color is r,g,b,a)\n"
              "    ifs a { newmap color: 1,1,1,1,1 }\n"
              "                                 ^");
}

TEST(ParserErrors, a_word_that_is_none_of_the_allowed) {
    EXPECT_EQ(parse_messages("render { shading: smooth }"),
              "s.pxm:1:19: error: expected constant, low-pass, high-pass or facet, found 'smooth'\n"
              "    render { shading: smooth }\n"
              "                      ^");
}

TEST(ParserErrors, a_command_before_the_first_map) {
    EXPECT_EQ(parse_messages("ifs a {\n    scale: 0.5\n}"),
              "s.pxm:2:5: error: 'scale' belongs to a map: expected 'newmap' before it\n"
              "    scale: 0.5\n"
              "    ^");
}

TEST(ParserErrors, an_unclosed_block_is_named_at_the_next_one) {
    EXPECT_EQ(parse_messages("ifs a {\n  newmap\nobject b { cone }"),
              "s.pxm:3:1: error: expected '}', found 'object' (the 'ifs' of line 1 is not closed)\n"
              "    object b { cone }\n"
              "    ^");
    EXPECT_EQ(parse_messages("image {\n"),
              "s.pxm:2:1: error: expected '}', found the end of the file "
              "(the 'image' of line 1 is not closed)");
}

TEST(ParserErrors, a_keyword_for_a_name) {
    EXPECT_EQ(parse_messages("ifs scale { newmap }"),
              "s.pxm:1:5: error: expected the name of the ifs, found 'scale' "
              "(a keyword cannot be a name)\n"
              "    ifs scale { newmap }\n"
              "        ^");
}

TEST(ParserErrors, what_may_stand_only_once_stands_only_once) {
    EXPECT_EQ(parse_messages("camera {\n  fov: 40\n  fov: 50\n}\ncamera { }"),
              "s.pxm:3:3: error: 'fov' is given twice in this camera\n"
              "    fov: 50\n"
              "    ^\n"
              "s.pxm:5:1: error: a second 'camera': a scene has one (the first is in line 1)\n"
              "    camera { }\n"
              "    ^");
    EXPECT_EQ(parse_messages("object a { cone cylinder }"),
              "s.pxm:1:17: error: 'cylinder' is a second volume: an object has one\n"
              "    object a { cone cylinder }\n"
              "                    ^");
    EXPECT_EQ(parse_messages("ifs a { newmap weight: 1 newmap weight: 2 }"), "");
    EXPECT_NE(parse_messages("ifs a { newmap weight: 1 weight: 2 }"), "");
    EXPECT_NE(parse_messages("image { } image { }"), "");
    EXPECT_NE(parse_messages("render { } render { }"), "");
    EXPECT_NE(parse_messages("let a = 1 let a = 1 cone { }"), "");
    EXPECT_NE(parse_messages("texture a { wood ifs: b }"), "");
}

TEST(ParserErrors, a_string_without_its_end) {
    EXPECT_EQ(parse_messages("texture a {\n  file: \"wood.png\n}"),
              "s.pxm:2:9: error: expected a file name in quotes, "
              "found a string without its closing '\"'\n"
              "    file: \"wood.png\n"
              "          ^");
}

TEST(ParserErrors, a_fraction_where_a_count_belongs) {
    EXPECT_EQ(parse_messages("render { samples: 5/2 }"),
              "s.pxm:1:19: error: expected a whole number, found 2.5\n"
              "    render { samples: 5/2 }\n"
              "                      ^");
}

TEST(ParserErrors, a_broken_arrow) {
    EXPECT_EQ(parse_messages("ifs a { newmap follow: 1 - > 1 }"),
              "s.pxm:1:26: error: expected '->', found '-' (follow: MAP -> MAP, ...)\n"
              "    ifs a { newmap follow: 1 - > 1 }\n"
              "                             ^");
}

TEST(ParserErrors, an_empty_scene) {
    EXPECT_EQ(parse_messages(""), "s.pxm:1:1: error: the scene is empty");
    EXPECT_EQ(parse_messages("# nothing\nlet a = 1\n"),
              "s.pxm:1:1: error: the scene is empty\n    # nothing\n    ^");
}

TEST(ParserErrors, a_file_that_is_not_text) {
    EXPECT_EQ(parse_messages(std::string("ifs a\nb\0c", 9)),
              "s.pxm:2:2: error: byte 0x00: this is not a text file\n"
              "    b?c\n"
              "     ^");
    EXPECT_EQ(parse_messages("ifs \x89PNG"),
              "s.pxm:1:5: error: expected the name of the ifs, found byte 0x89\n"
              "    ifs ?PNG\n"
              "        ^");
}

TEST(ParserErrors, several_mistakes_are_found_in_one_run) {
    const std::string messages = parse_messages(
        "ifs a {\n newmap\n scale 0.5\n rotate: w,5\n translate: 1,2,3,4\n}\n"
        "camera { fov: 1/0 eye: 1,2 }\nlight { shadow: maybe }\nlet x 3\n");
    for (const char* place : {"s.pxm:3:8:", "s.pxm:4:10:", "s.pxm:5:18:", "s.pxm:7:16:",
                              "s.pxm:7:28:", "s.pxm:8:17:", "s.pxm:9:7:"})
        EXPECT_NE(messages.find(place), std::string::npos) << place << "\n" << messages;
    EXPECT_EQ(std::ranges::count(messages, '^'), 7) << messages;
}

TEST(ParserErrors, an_error_in_an_included_file_names_that_file) {
    EXPECT_EQ(parse_messages("include: \"b.pxm\"\nifs a { newmap }", {{"b.pxm", "\nlet x = ,"}}),
              "b.pxm:2:9: error: expected a number, found ','\n"
              "    let x = ,\n"
              "            ^");
}

}  // namespace
}  // namespace pxm::host
