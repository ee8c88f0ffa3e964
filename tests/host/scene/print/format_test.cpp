// Laws of host/scene/print/format: formatting changes neither what a scene says nor its comments,
// and formatting twice is formatting once.
#include "host/scene/print/format.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "host/scene/parse/source_pieces.hpp"
#include "host/scene/print/print.hpp"
#include "tests/host/scene/random_scene.hpp"
#include "tests/host/scene/scene_text.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

namespace pxm::host {
namespace {

/// Tokens and comments, in order, without what is between them.
std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    for (const Piece& piece : pieces_of(text)) {
        for (const Comment& comment : piece.before.comments) words.push_back(comment.text);
        words.push_back(piece.text);
    }
    return words;
}

void expect_same_and_settled(const std::string& text) {
    const std::string formatted = format_scene(text);
    EXPECT_EQ(words_of(formatted), words_of(text)) << text;
    EXPECT_EQ(format_scene(formatted), formatted) << text;
    std::size_t start = 0;
    while (start < formatted.size()) {
        const std::size_t end = formatted.find('\n', start);
        ASSERT_NE(end, std::string::npos) << "the last line has no end";
        EXPECT_FALSE(end > start &&
                     std::string(" \t\r").find(formatted[end - 1]) != std::string::npos)
            << formatted;
        start = end + 1;
    }
}

/// The text with other blanks, newlines and comments between its tokens, where there are any.
std::string scattered(const std::string& text, unsigned seed) {
    static constexpr const char* gaps[] = {" ",    " ",       "  ",          "\n",
                                           "\t ",  "\r\n",    "\n\n\n",      "\n    ",
                                           " # a", "# b  \n", "\n\n  # c\n", " #\n# d\n\n"};
    std::mt19937 random(seed);
    const auto choose = [&](unsigned of) { return static_cast<unsigned>(random() % of); };
    const unsigned used = 1 + choose(std::size(gaps));
    std::string scattered;
    for (const Piece& piece : pieces_of(text)) {
        const bool apart = piece.before.breaks() || piece.before.blanks > 0;
        // A token that stands alone (`,`) may be moved away from its neighbours as well.
        const bool alone = piece.kind == TokenKind::symbol && choose(4) == 0;
        if (apart || alone) {
            scattered += gaps[choose(used)];
            if (scattered.ends_with('a')) scattered += '\n';
        }
        scattered += piece.text;
    }
    return scattered;
}

TEST(Format, random_scenes_say_the_same_however_they_were_written) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        const Scene scene = test::RandomScene(seed).scene();
        const std::string text = scattered(print_scene(scene), seed);
        expect_same_and_settled(text);
        EXPECT_TRUE(test::parsed(format_scene(text)) == scene) << text;
        if (HasFailure()) return;
    }
}

TEST(Format, the_scenes_that_come_with_pxm_are_formatted) {
    namespace fs = std::filesystem;
    int scenes = 0;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(test::source_dir) / "scenes")) {
        if (entry.path().extension() != ".pxm") continue;
        ++scenes;
        SCOPED_TRACE(entry.path().string());
        const std::string text = test::text_of(entry.path());
        EXPECT_EQ(format_scene(text), text);
        expect_same_and_settled(text);
        Diagnostics diagnostics;
        const Scene scene = parse_text(entry.path(), text, diagnostics);
        EXPECT_TRUE(parse_text(entry.path(), format_scene(text), diagnostics) == scene);
        EXPECT_FALSE(diagnostics.has_errors());
    }
    EXPECT_GT(scenes, 30);
}

TEST(Format, blocks_directives_and_values_have_their_lines_and_blanks) {
    EXPECT_EQ(
        format_scene("\xef\xbb\xbf\r\n\r\n# a tree\r\nlet  third=1/3\n"
                     "let half = ( 1 - 1 / 2 )# of it\n\n\n\n"
                     "include :\"parts/a.pxm\"  ifs tree\n{ newmap stem scale : third , 0.5,1\n"
                     "rotate:y,45   weight: 2 # thick\n\n  newmap matrix: 1,0,0,\n0,1,0, 0,0,1,"
                     " 0,0,0 color: 1,0,0,1\n follow: stem->2\n # the end\n\n}\n"
                     "object a{ifs:tree}object b { sphere: ( 0,0,0 )3   ifs:tree }\n"
                     "render { }"),
        "# a tree\n"
        "let third = 1/3\n"
        "let half = (1 - 1 / 2)    # of it\n"
        "\n"
        "include: \"parts/a.pxm\"\n"
        "ifs tree {\n"
        "    newmap stem scale: third, 0.5,1\n"
        "        rotate: y,45  weight: 2    # thick\n"
        "\n"
        "    newmap matrix: 1,0,0,\n"
        "            0,1,0, 0,0,1, 0,0,0 color: 1,0,0,1\n"
        "    follow: stem -> 2\n"
        "    # the end\n"
        "}\n"
        "object a { ifs: tree }\n"
        "object b { sphere: (0,0,0)3  ifs: tree }\n"
        "render {}\n");
}

TEST(Format, comments_behind_neighbouring_lines_stand_in_one_column) {
    EXPECT_EQ(format_scene("let a = 1 # one\nlet longer = 2 # two\n\nlet b = 3 # three\n"),
              "let a = 1         # one\n"
              "let longer = 2    # two\n"
              "\n"
              "let b = 3    # three\n");
}

TEST(Format, a_line_too_long_for_120_columns_is_broken_between_directives) {
    const std::string color = "color: 0.123456789,0.123456789,0.123456789,0.123456789";
    const std::string text = "object a { ifs: a " + color +
                             " translate: 1000000,2000000,3000000 "
                             "diffuse: 0.123456789 opacity: 0.5 }\n";
    EXPECT_EQ(format_scene(text),
              "object a {\n"
              "    ifs: a " +
                  color +
                  " translate: 1000000,2000000,3000000\n"
                  "    diffuse: 0.123456789 opacity: 0.5\n"
                  "}\n");
    expect_same_and_settled(text);
}

TEST(Format, a_comment_stands_anywhere) {
    expect_same_and_settled(
        "# first\nifs # kind\na # name\n{ # open\n\n# own\nnewmap # map\nscale # s\n"
        ": # colon\n0.5 # x\n, # comma\n1,1 # last\n\n# before the brace\n} # shut\n"
        "\n\n# at the end");
    expect_same_and_settled("");
    expect_same_and_settled("# only a comment");
    expect_same_and_settled("let a = ( # open\n1 # one\n) # shut\n* # times\n-2\n");
}

}  // namespace
}  // namespace pxm::host
