// Laws of the assembler: what it makes of a program, and what it says of mistakes.
#include "pxm/dsp32/assembler/assembler.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

namespace pxm::dsp32::assembler {
namespace {

using isa::Dialect;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> mistakes_in(const std::string& source, Dialect dialect = Dialect::dsp32) {
    std::vector<std::string> texts;
    for (const Mistake& mistake : assemble(source, dialect).mistakes)
        texts.push_back(std::to_string(mistake.place.line) + ":" +
                        std::to_string(mistake.place.column) + ": " + mistake.message);
    return texts;
}

Object object_in(const std::string& source, Dialect dialect = Dialect::dsp32) {
    EXPECT_THAT(mistakes_in(source, dialect), IsEmpty());
    return assemble(source, dialect).object;
}

TEST(Assembler, the_published_syntax_is_read) {
    const Object object = object_in(
        "/* Two sums of products,\n"
        "   as the library writes them. */\n"
        ".equ count, 2 * 4\n"
        "start:  r1 = table              // a label\n"
        "        r2 = count + 0x10\n"
        "        a0 = a1 + *r1++ * *r2++\n"
        "        *r3++r15 = a1=-*r4-- - a2**r5\n"
        "        if (r5-- >= 0) goto start\n"
        "        nop\n"
        "        return (r14)\n"
        "        nop\n"
        ".data\n"
        "table:  2*float 1.0, -0.1\n"
        "        int 3, -1\n");
    EXPECT_THAT(object.text, ElementsAre(0x14200020, 0x14400018, 0x6405c787, 0x29aa1319, 0x0ca00000,
                                         0, 0x002e0000, 0));
    EXPECT_THAT(object.data,
                ElementsAre(0x00000080, 0xb333337c, 0x00000080, 0xb333337c, 0xffff0003));
    EXPECT_THAT(object.symbols, ElementsAre(Symbol{"start", 0}, Symbol{"table", 0x20}));
}

TEST(Assembler, the_example_of_its_document_is_a_program) {
    const std::string document =
        test::text_of(std::filesystem::path(test::source_dir) / "docs/dsp32.md");
    const std::size_t start = document.find("        .equ    count");
    ASSERT_NE(start, std::string::npos);
    const Object object = object_in(document.substr(start, document.find("```", start) - start));
    EXPECT_EQ(object.text.size(), 9U);
    EXPECT_EQ(object.data.size(), 6U);
}

TEST(Assembler, numbers_are_those_that_the_host_broadcasts) {
    const Object object = object_in(".data\nfloat 0.1, -0.1, 3, 1e40, -1e-3, 1e-60\n");
    EXPECT_THAT(object.data, ElementsAre(word_of(0.1), word_of(-0.1), word_of(3.0), largest,
                                         word_of(-1e-3), zero));
}

TEST(Assembler, a_difference_of_a_register_and_a_constant_sets_the_borrow_where_it_can) {
    // With the result in its own register it is a subtraction, else the addition of the negative.
    EXPECT_THAT(object_in("r1 = r1 - 4\nr1 = r2 - 4\nr1 = r1 + 4\n").text,
                ElementsAre(0x1a810004, 0x1422fffc, 0x14210004));
}

TEST(Assembler, mistakes_have_a_line_a_column_and_a_reason) {
    EXPECT_THAT(
        mistakes_in("foo r1\n"
                    " a0 = a1 *\n"
                    "r1 = r2 * 3\n"
                    " r1 = 99999\n"
                    " goto 0x9000\n"
                    "x: x: .bar\n"
                    " a0 = seed(*r1)\n"
                    " *r15 = a0 = a1\n"
                    " r1 = *r2++r16 junk\n"
                    " r1 = here\n"
                    " r1 = r2 + r3\n"
                    "x1: if (r2-- > 0) goto x1\n"),
        ElementsAre(
            "1:1: unknown instruction \"foo\"",
            "2:11: expected an accumulator or memory, found the end of the line",
            "3:11: what stands behind this sign is out of range: 3, allowed are 2 to 2",
            "4:7: the constant is out of range: 99999",
            "5:7: a branch to 36864: the program's instructions are at 0 to 40, by four",
            "6:4: \"x\" is there twice", "6:7: unknown directive \".bar\"",
            "7:7: only the DSP32C has this instruction", "8:3: expected a pointer, r1 to r14",
            "9:16: expected the end of the line, found \"junk\"", "10:7: there is no \"here\"",
            "11:2: here the result has to be one of the operands",
            "12:14: expected \">=\", found \">\""));
}

TEST(Assembler, what_the_dsp32c_added_is_switched_by_the_dialect) {
    for (const char* later : {"a0 = seed(*r1)", "r1e = *r2++", "do 3, 10", "r1 = r2 + r3",
                              "if (eq) r1 = r1 + r2", "r1e = 0x123456", "*r1 = a0 = dsp(*r1)"}) {
        EXPECT_EQ(mistakes_in(later).size(), 1U) << later;
        EXPECT_THAT(mistakes_in(later, Dialect::dsp32c), IsEmpty()) << later;
        EXPECT_THAT(mistakes_in(std::string(".dsp32c\n") + later), IsEmpty()) << later;
    }
}

TEST(Assembler, forms_that_the_data_unit_lacks_are_refused) {
    for (const char* form : {"a0 = *r1 + *r2 * *r3", "a0 = 2.0 * *r1", "a0 = a1 + 1.0",
                             "a0 = (*r1 = *r2)", "*r1 = a0 = (*r2 = *r3) + a1",
                             "a0 = *r1 * (*r2 = *r3)", "a0 = a1 + a2 + a3", "a1 = a0 * *r15"})
        EXPECT_EQ(mistakes_in(form).size(), 1U) << form;
}

TEST(Assembler, a_program_too_large_says_its_words_and_takes_no_memory) {
    const Assembly assembly = assemble("nop\n.space 40000\n", Dialect::dsp32);
    EXPECT_TRUE(assembly.too_large());
    EXPECT_EQ(assembly.words, 10'001);
    EXPECT_EQ(assembly.words_limit, 9'216);
    EXPECT_EQ(assembly.object.words(), 0U);
    EXPECT_TRUE(assemble(".data\n9999999*float 0\n", Dialect::dsp32).too_large());
    EXPECT_FALSE(assemble(".space 36864\n", Dialect::dsp32).too_large());
}

TEST(Assembler, what_is_not_aligned_is_refused) {
    EXPECT_THAT(mistakes_in(".data\nint 1\nfloat 1\n"),
                ElementsAre("3:7: this lies at no multiple of 4 bytes; .align 4 goes to the next"));
    EXPECT_THAT(mistakes_in(".data\nint 1\n.align 4\nfloat 1\n"), IsEmpty());
}

TEST(Assembler, a_listing_has_addresses_and_words_beside_the_source) {
    const std::string source = "// head\nstart: nop\n\n r1 = 1\n.data\n 2*float 1\n";
    EXPECT_EQ(listing(assemble(source, Dialect::dsp32), source),
              "                // head\n"
              "0000  00000000  start: nop\n"
              "\n"
              "0004  14200001   r1 = 1\n"
              "                .data\n"
              "0008  00000080   2*float 1\n"
              "000c  00000080\n");
}

TEST(Assembler, an_object_comes_back_from_its_file_and_from_its_disassembly) {
    std::mt19937_64 engine(5);
    for (int i = 0; i < 50; ++i) {
        Object object;
        object.dialect = i % 2 == 0 ? Dialect::dsp32 : Dialect::dsp32c;
        for (int w = 0; w < 40; ++w) object.text.push_back(static_cast<Word>(engine()));
        for (int w = 0; w < 5; ++w) object.data.push_back(static_cast<Word>(engine()));
        object.text.push_back(0x00200010);  // goto loop
        object.symbols = {{"start", 0}, {"loop", 0x10}, {"table", 41 * 4}};
        EXPECT_EQ(object_of(text_of(object)), object);
        EXPECT_EQ(object_in(disassembly(object)), object) << disassembly(object);
    }
    for (const char* broken : {"", "pxm-object 1 dsp32\n", "pxm-object 1 dsp32\ntext 2\n00000000\n",
                               "pxm-object 2 dsp32\ntext 0\ndata 0\n",
                               "pxm-object 1 dsp32\ntext 0\ndata 0\nsymbol 0000\n"})
        EXPECT_FALSE(object_of(broken)) << broken;
}

TEST(Assembler, any_text_is_assembled_or_refused) {
    const std::string_view pieces[] = {
        "a0",   "r1",   "*",  "++",   "=",    " ",    "\n", "(",      ")",  "-",     "1.0",
        "0x10", "goto", "if", ",",    ".equ", "x",    ":",  ">=",     "/*", ".data", "int",
        "#",    "\"",   "/",  "99e9", "nop",  "call", ".",  ".space", "--", "float"};
    std::mt19937_64 engine(7);
    for (int i = 0; i < 20'000; ++i) {
        std::string source;
        for (int k = 0; k < 30; ++k) source += pieces[engine() % std::size(pieces)];
        const Assembly assembly = assemble(source, Dialect::dsp32);
        EXPECT_LE(assembly.mistakes.size(), mistake_limit);
    }
}

TEST(Assembler, parentheses_and_numbers_have_an_end) {
    EXPECT_EQ(mistakes_in("r1 = " + std::string(100'000, '(')).size(), 1U);
    EXPECT_EQ(mistakes_in("r1 = " + std::string(100'000, '-') + "1").size(), 1U);
    EXPECT_EQ(mistakes_in("r1 = 99999999999999999999").size(), 1U);
    EXPECT_EQ(mistakes_in("r1 = 0x7fffffffffffffff * 4").size(), 1U);
    EXPECT_EQ(mistakes_in("r1 = 1 / 0").size(), 1U);
}

}  // namespace
}  // namespace pxm::dsp32::assembler
