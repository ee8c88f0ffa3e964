// The chaos game (Alg. 7.1) for any RIFS, weakly connected ones included. Each new map goes on the
// outside, so the graph's edges are walked backwards: a point that may stand where map m ends is
// carried to where m may stand. One running point is kept for every follow set; the plotted points
// are those drawn for the start set, and a walk down the graph keeps the running points of all
// other sets fresh. Every set's point then has the distribution it has in a random descent from the
// start: map m of a set is taken with probability weight_m over the sum of the set's weights.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "host/fractal/alias_table.hpp"
#include "host/fractal/rifs.hpp"

namespace pxm::host {

/// Blending along a word is affine in the colour it starts from: c -> keep c + add.
struct ColorBlend {
    double keep = 1;
    glm::dvec3 add{0.0};

    [[nodiscard]] glm::dvec3 of(const glm::dvec3& c) const { return keep * c + add; }
};

/// A point of the attractor and what its word does to a colour.
struct CloudPoint {
    glm::dvec3 place{0.0};
    ColorBlend blend;
};

/// Weights of the maps where the scene gives none: |det|, floored at a thousandth of the largest
/// (or of an even share) so that no map is starved.
[[nodiscard]] std::vector<double> default_weights(const Rifs& rifs);

class ChaosGame {
  public:
    /// `weights` and `colors` (r,g,b,a) per map. The same seed gives the same points, whatever
    /// draws them. Precondition: the system contracts by `rate` a map in the long run.
    ChaosGame(const Rifs& rifs, const std::vector<double>& weights,
              const std::vector<glm::dvec4>& colors, double rate, std::uint64_t seed);

    /// The next point.
    [[nodiscard]] const CloudPoint& next();

  private:
    /// A map with all that a step reads, close together.
    struct Step {
        glm::dvec3 row[3];
        glm::dvec3 offset;
        glm::dvec3 paint;
        double keep;
        std::uint32_t inside;  // the follow set whose point it carries
    };
    struct Set {
        AliasTable table;
        std::vector<std::uint32_t> maps;
    };

    [[nodiscard]] std::uint64_t random_bits();
    [[nodiscard]] std::uint32_t draw(std::uint32_t set);
    void refresh();
    void settle(const Rifs& rifs, long rounds);

    std::vector<Step> steps_;
    std::vector<Set> sets_;
    std::vector<CloudPoint> points_;  // one per follow set
    std::uint32_t start_;
    std::uint32_t walker_;  // the set that is refreshed next
    bool single_;           // the start set is the only one
    std::uint64_t seed_;
    std::uint64_t counter_ = 0;
    std::uint64_t spare_bits_ = 0;
    bool has_spare_ = false;
};

}  // namespace pxm::host
