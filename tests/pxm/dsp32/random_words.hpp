// Random memory words that meet the corners often: the same on every compiler for the same seed.
#pragma once

#include <array>
#include <cstdint>
#include <random>

#include "pxm/dsp32/word.hpp"

namespace pxm::dsp32 {

class RandomWords {
  public:
    explicit RandomWords(std::uint64_t seed) : engine_(seed) {}

    /// A word; one in eight is close to the negative of the word before, so that sums cancel.
    Word operator()() {
        const auto bits = static_cast<std::uint64_t>(engine_());
        const auto word = static_cast<Word>(bits);
        switch (bits >> 61) {
            case 0:
                return last_ = corners[(bits >> 32) % corners.size()];
            case 1:
                return last_ = word;  // any exponent
            case 2:
                return last_ = near(last_ ^ 0xFFFFFF00U, bits);
            default:
                return last_ = (word & 0xFFFFFF00U) | (112 + (bits >> 32) % 32);
        }
    }

  private:
    static constexpr std::array<Word, 14> corners{
        zero,    one,           0x8000007F, 0x00000081, 0x7FFFFF80, 0x80000080, 0xFFFFFF80,
        largest, most_negative, 0x00000001, 0xFFFFFF01, 0x80000001, 0x7FFFFF01, 0x12345600};

    static Word near(Word word, std::uint64_t bits) {
        return word ^ (static_cast<Word>(bits >> 32) & 0x300U);
    }

    std::mt19937_64 engine_;
    Word last_ = one;
};

}  // namespace pxm::dsp32
