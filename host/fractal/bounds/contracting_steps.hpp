// A contracting system as steps from follow set to follow set, each in coordinates where it
// shrinks: what balls are found for whose images lie inside them (invariant_ball.hpp).
#pragma once

#include <glm/mat3x3.hpp>
#include <optional>
#include <vector>

#include "host/fractal/system/contraction.hpp"
#include "host/math/bracket_matrix.hpp"

namespace pxm::host {

/// The map of one or more steps: a map of the system, or of a word of maps.
struct StepMap {
    Affine map;  // as well as double can hold it
    BracketMatrix linear;
    BracketVector translation;
};

/// maps[map] takes what stands in follow set `to` into the set that the step is from. In the
/// coordinates of the sets it is `lip` times as large there, at most.
struct Step {
    int to;
    int map;
    double lip;
};

/// Coordinates of follow set s: x there is frame[s] * x in space.
struct Frames {
    std::vector<glm::dmat3> frame;  // lower triangular
    std::vector<glm::dmat3> into;   // its inverse, as well as double can hold it
    std::vector<BracketMatrix> proven_into;
};

struct Steps {
    std::vector<StepMap> maps;
    std::vector<std::vector<Step>> from;  // by follow set
    std::vector<double> weight;           // lip weight[to] < weight[from] within a component
    std::optional<Frames> frames;         // nothing: all coordinates are those of space
};

/// By a kind of proof that was found for the system; nothing if there is no such proof.
[[nodiscard]] std::optional<Steps> contracting_steps(const Rifs& rifs, ContractionProof proof);

}  // namespace pxm::host
