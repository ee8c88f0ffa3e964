// No text makes the parser crash, run for ever, or stay silent about where it failed.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "host/scene/parse/lexer.hpp"
#include "host/scene/print/print.hpp"
#include "tests/host/scene/random_scene.hpp"
#include "tests/host/scene/scene_text.hpp"

namespace pxm::host {
namespace {

/// Parses and checks; every error has a place, there are at most 20, and what is accepted prints
/// and reads back the same.
void survives(const std::string& text) {
    Diagnostics diagnostics;
    const Scene scene = parse_text("s.pxm", text, diagnostics, test::reader_of({}));
    const std::string messages = diagnostics.text(scene.files);
    std::size_t errors = 0;
    std::size_t placed = 0;
    for (std::size_t at = messages.find("error: "); at != std::string::npos;
         at = messages.find("error: ", at + 1))
        ++errors;
    for (std::size_t at = messages.find("s.pxm:"); at != std::string::npos;
         at = messages.find("s.pxm:", at + 1))
        ++placed;
    ASSERT_GE(placed, errors) << messages;
    ASSERT_EQ(errors > 0, diagnostics.has_errors());
    ASSERT_LE(messages.size(), 20'000U);
    if (!diagnostics.has_errors()) {
        ASSERT_TRUE(test::parsed(print_scene(scene)) == scene);
    }
    check_scene(scene, diagnostics);
    (void)diagnostics.text(scene.files);
}

std::string mutated(std::string text, std::mt19937& random) {
    static const std::string bytes = "{}(),:=+-*/>\"#\n 09.eaz_\x93\t";
    for (std::size_t i = 1 + random() % 4; i > 0 && !text.empty(); --i) {
        const std::size_t at = random() % text.size();
        const std::size_t length = std::min<std::size_t>(random() % 12, text.size() - at);
        const char byte =
            random() % 4 == 0 ? static_cast<char>(random() % 256) : bytes[random() % bytes.size()];
        switch (random() % 4) {
            case 0:
                text[at] = byte;
                break;
            case 1:
                text.insert(at, 1, byte);
                break;
            case 2:
                text.erase(at, length);
                break;
            default:
                text.insert(random() % text.size(), text.substr(at, length));
                break;
        }
    }
    return text;
}

TEST(ParserHostile, mutated_scenes_end_in_a_scene_or_in_errors_with_places) {
    for (unsigned seed = 0; seed < 4000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        survives(mutated(print_scene(test::RandomScene(seed % 100).scene()), random));
        if (HasFatalFailure()) return;
    }
}

TEST(ParserHostile, random_words_of_the_language_end) {
    static const char* words[] = {"ifs",   "{",   "}",    "newmap", "scale",  ":",      "0.5",
                                  ",",     "(",   ")",    "->",     "object", "a",      "let",
                                  "=",     "-",   "cone", "/",      "light",  "follow", "start",
                                  "color", "1",   "sqrt", "\"x",    "\"",     "\n",     "render",
                                  "#",     "box", "low",  "texture"};
    for (unsigned seed = 0; seed < 4000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::string text;
        for (std::size_t i = random() % 60; i > 0; --i)
            text += words[random() % std::size(words)] + std::string(random() % 2, ' ');
        survives(text);
        if (HasFatalFailure()) return;
    }
}

/// A megabyte of one thing takes time in proportion: these would take hours if it were squared.
TEST(ParserHostile, a_megabyte_of_anything_is_read_in_one_pass) {
    const auto repeated = [](const std::string& unit) {
        std::string text;
        while (text.size() < 1'000'000) text += unit;
        return text;
    };
    for (const char* unit : {"{", "}", "(", ")", "-", "->", "\"", "a", "1", ":", "\xff", "a:", "\n",
                             "ifs a {", "let a = ", "newmap ", "include: \"x\" ", "ifs a { } "})
        survives(repeated(unit));
    for (const char* start : {"let a = ", "ifs a { newmap scale: ", "object a { sphere: (",
                              "ifs a { newmap follow: ", "texture a { file: "})
        for (const char* unit : {"(", "-", "1,", "1+", "1"}) survives(start + repeated(unit));
}

TEST(ParserHostile, a_megabyte_of_random_bytes_is_refused) {
    std::mt19937 random(1);
    std::string bytes(1'000'000, 'x');
    for (char& byte : bytes) byte = static_cast<char>(random() % 255 + 1);
    EXPECT_NE(test::parse_messages(bytes), "");
    survives(bytes);
    bytes[500'000] = '\0';
    survives(bytes);
}

TEST(ParserHostile, nothing_but_printable_characters_reaches_the_terminal) {
    std::string bytes;
    for (int i = 1; i < 256; ++i) {
        bytes += 'x';
        bytes += static_cast<char>(i);
        bytes += ' ';
    }
    for (const char c : test::parse_messages(bytes) + test::parse_messages("ifs \x1b[31m {"))
        EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << static_cast<int>(c);
}

TEST(ParserHostile, tokens_cover_the_text_once) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937 random(seed);
        std::string text;
        for (std::size_t i = random() % 50; i > 0; --i)
            text += static_cast<char>(random() % 255 + 1);
        Lexer lexer(text, 0);
        std::size_t bytes = 0;
        Token token = lexer.next();
        const char* end = text.data();
        for (; token.kind != TokenKind::end; token = lexer.next()) {
            ASSERT_GE(token.text.data(), end) << "seed " << seed;
            end = token.text.data() + token.text.size();
            bytes += token.text.size();
        }
        ASSERT_LE(bytes, text.size()) << "seed " << seed;
        ASSERT_EQ(lexer.next().kind, TokenKind::end);
    }
}

}  // namespace
}  // namespace pxm::host
