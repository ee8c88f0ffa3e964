// Compares a frame with the oracle, pixel by pixel (docs/design.md, decision 4).
#pragma once

#include <string>
#include <vector>

#include "host/engine/frame.hpp"
#include "tests/support/oracle.hpp"

namespace pxm::test {

/// The frame's 24-bit hash of a word, computed from the word.
[[nodiscard]] std::uint32_t hash_of(const std::vector<int>& word);

/// Whether a pixel shows that cell: its object, level, word and depth.
[[nodiscard]] bool shows(const host::CompiledScene& scene, const host::PixelRecord& pixel,
                         const TerminalCell& cell);
/// Whether a pixel is as one is that misses.
[[nodiscard]] bool is_miss(const host::PixelRecord& pixel);
/// Whether a pixel has that colour, within 1/255.
[[nodiscard]] bool same_color(const host::PixelRecord& pixel, const glm::dvec3& color);
/// The share of an object's diameter below which p does not fall.
[[nodiscard]] double smallest_share(host::Numeric numeric);

/// What a frame's pixels are worth.
struct Verdict {
    long pixels = 0;
    long hits = 0;          // by the oracle
    long same = 0;          // the same cell (or a miss by both), with the same level and z
    long tied = 0;          // another terminal cell whose key differs by rounding only
    long admissible = 0;    // the same, or another that decision 4 admits
    long wrong_colors = 0;  // of admissible pixels: off by more than 1/255 for the cell shown
    std::string report;     // the first few disagreements: pixel, both words and keys

    /// Ties are cells that coincide, or whose faces do: there rounding decides.
    [[nodiscard]] double same_share() const {
        return static_cast<double>(same + tied) / static_cast<double>(pixels);
    }
    [[nodiscard]] double admissible_share() const {
        return static_cast<double>(admissible) / static_cast<double>(pixels);
    }
};

/// Judges all pixels of a frame that was rendered from `scene`.
[[nodiscard]] Verdict judge(const host::CompiledScene& scene, const host::Frame& frame,
                            host::Numeric numeric);

}  // namespace pxm::test
