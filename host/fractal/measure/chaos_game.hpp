// The chaos game for any RIFS, weakly connected ones included. Alg. 7.1 carries one point on and
// on, each new map on the outside; here every point has a random word of its own, outermost map
// first, which goes on until what is left of the attractor inside it is below the resolution of a
// double. So points are independent, they come with exactly the distribution of a random descent
// from the start (in a follow set, map m with probability weight_m over the sum of the set's
// weights), and none is a repetition unless the attractor leaves no choice.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "host/fractal/measure/random_words.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// A point of the attractor and what its word does to a colour.
struct CloudPoint {
    glm::dvec3 place{0.0};  // where it lies
    ColorBlend blend;       // of the colours that its maps paint
};
/// Draws the points of one system.
class ChaosGame {
  public:
    /// `weights` and `colors` (r,g,b,a) per map. The same seed and number give the same points,
    /// whatever draws them; games that differ in either draw independently. Precondition: the
    /// system contracts.
    ChaosGame(const Rifs& rifs, const std::vector<double>& weights,
              const std::vector<glm::dvec4>& colors, std::uint64_t seed, std::uint32_t number = 0);

    /// The next point.
    [[nodiscard]] CloudPoint next();
    /// The next point becomes the first of chunk `chunk`, each of which has room for chunk_points:
    /// chunks may be drawn in any order, each by a copy of the game. It begins with chunk 0.
    void seek(std::uint32_t chunk);

    static constexpr std::uint64_t chunk_points = 1 << 16;  // of seek()

  private:
    [[nodiscard]] std::uint64_t random_bits();

    RandomWords words_;
    std::vector<glm::dvec3> inner_;  // per follow set: a point of E_s
    std::vector<double> reach_;      // and how far E_s extends around it, about
    double negligible_ = 0;          // a size that makes no difference
    std::uint32_t start_;
    std::uint64_t seed_;
    std::uint32_t number_;  // among the games of one seed
    std::uint64_t counter_ = 0;
    std::uint64_t spare_bits_ = 0;
    bool has_spare_ = false;
};

}  // namespace pxm::host
