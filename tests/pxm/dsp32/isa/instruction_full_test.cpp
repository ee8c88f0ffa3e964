// The laws of instruction_test.cpp on 10^8 words.
#include "tests/pxm/dsp32/isa/instruction_words.hpp"

namespace pxm::dsp32::isa {
namespace {

TEST(Dsp32Isa, a_hundred_million_words_come_back) {
    EXPECT_GT(try_words(20261130, 100'000'000), 50'000'000);
}

}  // namespace
}  // namespace pxm::dsp32::isa
