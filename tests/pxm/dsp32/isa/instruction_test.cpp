// Laws of pxm/dsp32/isa: the table's formats exclude each other, decoding and encoding undo each
// other, and the text of a word is what other people's disassemblers print.
#include "tests/pxm/dsp32/isa/instruction_words.hpp"

#include <gmock/gmock.h>

#include <bit>

#include "pxm/dsp32/isa/names.hpp"

namespace pxm::dsp32::isa {
namespace {

std::string without_spaces(std::string text) {
    std::erase(text, ' ');
    return text;
}

/// As MAME writes it: its numbers start with $.
std::string as_mame_writes(Word word) {
    std::string text = without_spaces(text_of(*decode(word, Dialect::dsp32c), Dialect::dsp32c));
    for (auto at = text.find("0x"); at != std::string::npos; at = text.find("0x"))
        text.replace(at, 2, "$");
    return text;
}

struct WordAndText {
    Word word;
    const char* text;
};

TEST(Dsp32Isa, every_bit_of_a_format_is_fixed_or_in_one_field) {
    for (const Format& format : formats()) {
        Word covered = format.fixed_mask;
        for (int i = 0; i < format.field_count; ++i) {
            const Field& field = format.fields[static_cast<std::size_t>(i)];
            const Word bits = ((Word{1} << field.bits) - 1) << field.low_bit;
            EXPECT_EQ(covered & bits, 0U) << format.pattern;
            covered |= bits;
        }
        EXPECT_EQ(covered, 0xFFFF'FFFFU) << format.pattern;
    }
}

TEST(Dsp32Isa, no_word_has_two_formats) {
    const auto all = formats();
    for (std::size_t a = 0; a < all.size(); ++a) {
        for (std::size_t b = a + 1; b < all.size(); ++b) {
            // The return from an interrupt is a branch through pcsh, which branches do not allow.
            if (all[a].operation == Operation::branch &&
                all[b].operation == Operation::interrupt_return)
                continue;
            const Word both = all[a].fixed_mask & all[b].fixed_mask;
            EXPECT_NE(all[a].fixed_bits & both, all[b].fixed_bits & both)
                << all[a].pattern << " and " << all[b].pattern;
        }
    }
}

TEST(Dsp32Isa, words_come_back_from_decoding_and_texts_from_assembling) {
    EXPECT_GT(try_words(1, 100'000), 50'000);
}

TEST(Dsp32Isa, what_the_first_has_the_dsp32c_has_with_the_same_fields) {
    InstructionWords words(2);
    for (int i = 0; i < 100'000; ++i) {
        const Word word = words();
        const auto first = decode(word, Dialect::dsp32);
        if (!first) continue;
        const auto later = decode(word, Dialect::dsp32c);
        ASSERT_TRUE(later) << std::hex << word;
        EXPECT_EQ(first->format, later->format);
        EXPECT_EQ(first->values, later->values);
    }
}

TEST(Dsp32Isa, the_first_dsp32_has_no_seed_no_ieee_no_hardware_loop_and_16_bits) {
    EXPECT_FALSE(decode(0x7f400190, Dialect::dsp32));  // *r2 = a2 = seed(a3)
    EXPECT_FALSE(decode(0x7e200407, Dialect::dsp32));  // a1 = ieee(*r1)
    EXPECT_EQ(as_mame_writes(0x7e200407), "a1=ieee(*r1)");
    EXPECT_FALSE(decode(0x8c2f000b, Dialect::dsp32));  // do 15, r11
    EXPECT_FALSE(decode(0x94600040, Dialect::dsp32));  // r3e = 0x40
    EXPECT_FALSE(decode(0x1ec101d7, Dialect::dsp32));  // r1e = *r14++
    EXPECT_FALSE(decode(0xdfe3df00, Dialect::dsp32));  // r3e = 0xffdf00
    EXPECT_FALSE(decode(0x003e0000, Dialect::dsp32));  // ireturn
    EXPECT_EQ(text_of(*decode(0x003e0000, Dialect::dsp32c), Dialect::dsp32c), "ireturn");
}

// Words that the assembler makes of instructions of AT&T's library and of ELDORA's programs, in
// the order of their sources [S9, S12], and what MAME's disassembler prints for them, by its source
// [S7]: facts about the DSP32C.
const WordAndText words_of_real_programs[] = {
    {0x1ec101d7, "r1e = *r14++"},
    {0x30600407, "a3 = *r1"},
    {0x7f400190, "*r2 = a2 = seed(a3)"},
    {0x94600040, "r3e = $40"},
    {0x2c808f87, "a0 = *r3++ - a3 * a2"},
    {0x7027c807, "a1 = *r2 * *r3++"},
    {0x2cc40f87, "a2 = *r3++ - a3 * *r2"},
    {0x20000f87, "a0 = *r3++ + a0 * a0"},
    {0x70204007, "a1 = a0 * a1"},
    {0x002e0000, "goto r14"},
    {0x68004010, "*r2 = a0 = a2 + a0 * a1"},
    {0x002e0004, "goto r14+$4"},
    {0x94620004, "r3e = r2e + $4"},
    {0x14a0007f, "r5 = $7f"},
    {0x1f450040, "*r2 = r5l"},
    {0x1e460020, "r6l = *r1"},
    {0x14c6ff81, "r6 = r6 - $7f"},
    {0x1f860060, "*r3 = r6"},
    {0x79000c18, "*r3 = a0 = float(*r3)"},
    {0x2c299307, "a1 = *r4-- + a3 * *r4--"},
    {0x28441307, "a2 = *r4-- + a2 * *r2"},
    {0x70080c07, "a0 = *r3 * *r4"},
    {0x34000088, "*r1 = a0 = a1 + a0"},
    {0x34a9c807, "a1 = *r2 - *r4++"},
    {0x3409c007, "a0 = a0 + *r4++"},
    {0x19a600e0, "r6 = r7 / 2"},
    {0x6089c098, "*r3 = a0 = a0 - a1 * *r4++"},
    {0x01000010, "if (cc) goto $10"},
    {0x98340140, "r18e = r10e * 2"},
    {0x98930040, "r17e = r17e - r2e"},
    {0x98b20260, "r16e = -r17e"},
    {0x950afffd, "r8e = r10e - $3"},
    {0x18e30080, "r3 - r4"},
    {0x014fff78, "if (ge) goto pc-$88"},
    {0x3000098b, "*r1++r17 = a0 = *r2++r17"},
    {0x30001512, "*r2++r16 = a0 = *r5++r16"},
    {0x18640280, "r4 = r4 # r18"},
    {0x0d0fff68, "if (r8-- >= 0) goto pc-$98"},
    {0x980208c4, "r2e = r4e + r6e"},
    {0x8c2f000b, "do 15,r11"},
    {0x3484c587, "a0 = *r1++r17 - *r2++r17"},
    {0x352000bb, "*r7++r17 = a1 = -a1 + a0"},
    {0x610c05e3, "*r12++r17 = a0 = -a0 + *r1++r17 * *r6"},
    {0x2806c587, "a0 = *r1++r17 + a2 * *r3++r17"},
    {0x6080cd5b, "*r11++r17 = a0 = a0 - *r3++r16 * a3"},
    {0x2c26c507, "a1 = *r1++r16 + a3 * *r3++r17"},
    {0x60c80187, "a2 = a0 - a3 * *r4"},
    {0x1b04ffff, "r4 = r4 ^ $ffff"},
    {0x1b057fff, "r5 = r5 ^ $7fff"},
    {0x1f840057, "*r2++ = r4"},
    {0x1e840037, "r4 = *r1++"},
    {0x3486080e, "*r1-- = a0 = *r2 - *r3"},
    {0x60c00090, "*r2 = a2 = a0 - a1 * a0"},
    {0x00000000, "nop"},
    {0x17600554, "ioc = $554"},
    {0xdfe3df00, "r3e = $ffdf00"},
    {0x7f400407, "a2 = seed(*r1)"},
    {0x11c00020, "call $20 (r14)"},
};

TEST(Dsp32Isa, its_texts_are_those_of_mame_for_instructions_of_real_programs) {
    for (const auto& [word, text] : words_of_real_programs) {
        ASSERT_TRUE(decode(word, Dialect::dsp32c)) << text;
        EXPECT_EQ(as_mame_writes(word), without_spaces(text));
    }
}

// Words whose meaning the DSP3210's reference gives where the successor kept the encoding [S8].
TEST(Dsp32Isa, its_texts_are_those_of_the_dsp3210_where_the_encoding_stayed) {
    const WordAndText kept[] = {
        {0x3800079f, "a0 = (*r3++ = *r1++) + a0"},
        {0x0c22ff54, "if (r1-- >= 0) goto r2 - 0xac"},
        {0x10200040, "call 0x40 (r1)"},
        {0xa0001234, "goto 0x1234"},
        {0xe2583456, "call 0x123456 (r20)"},
        {0xa0220000, "goto r2 + 0x10000"},
    };
    for (const auto& [word, text] : kept)
        EXPECT_EQ(text_of(*decode(word, Dialect::dsp32c), Dialect::dsp32c), text);
}

TEST(Dsp32Isa, a_branch_shows_the_label_it_leads_to) {
    const LabelOf label_of = [](std::uint32_t at) { return at == 0x40 ? "loop" : ""; };
    const auto shown = [&](Word word) { return text_of(word, 0x10, Dialect::dsp32, label_of); };
    EXPECT_EQ(shown(0x00200040), "goto loop");
    EXPECT_EQ(shown(0x11c00040), "call loop (r14)");
    EXPECT_EQ(shown(0x0ca00040), "if (r5-- >= 0) goto loop");
    EXPECT_EQ(shown(0x026f0028), "if (alt) pcgoto loop");
    EXPECT_EQ(shown(0x00200044), "goto 0x44");
    EXPECT_EQ(shown(0xffffffff), ".word 0xffffffff");
}

TEST(Dsp32Isa, an_addition_is_excluded_from_the_first_dsp32_by_its_value_alone) {
    for (const Addition& addition : additions()) {
        for (const char letter : addition.letters) {
            EXPECT_FALSE(field_allows(letter, addition.first, Dialect::dsp32)) << addition.what;
            EXPECT_TRUE(field_allows(letter, addition.last, Dialect::dsp32c)) << addition.what;
        }
    }
}

}  // namespace
}  // namespace pxm::dsp32::isa
