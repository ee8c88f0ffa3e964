// How the words of an L-system in space grow (lsystem_growth.hpp has those of the plane).
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/import/lsystem/lsystem_growth.hpp"
#include "host/import/lsystem/space_turn.hpp"

namespace pxm::host {

/// What the turtle's state becomes by a symbol's drawing, the position left out.
struct SpaceState {
    SpaceTurn turn;
    LongReal step{1};
};

/// An occurrence of a symbol in a rule.
struct SpaceOccurrence {
    int symbol = 0;
    SpaceState state;
    glm::dvec3 place{0.0};  // along forward, left and up of where the rule begins
};

/// What is known of every symbol at one level.
struct SpaceLevel {
    std::vector<SpaceState> state;
    std::vector<LongVec3> displacement;
    std::vector<char> drawn;
};

/// The turns of the commands, worked out once.
class SpaceTurns {
  public:
    explicit SpaceTurns(const Lsystem& lsystem);
    /// What a command other than a symbol or a bracket does.
    void apply(const TurtleCommand& command, SpaceState& state) const;

  private:
    [[nodiscard]] const SpaceTurn& turn(int axis, const std::string& degrees) const;

    std::string step_;  // degrees, or a number of steps a turn behind a slash
    mutable std::map<std::pair<int, std::string>, SpaceTurn> known_;
};

/// As occurrences() of the plane.
[[nodiscard]] std::vector<SpaceOccurrence> space_occurrences(
    const std::vector<TurtleCommand>& commands, const SpaceTurns& turns, const SpaceLevel& level);

/// The levels of one period, as LsystemGrowth has them; all lengths grow by `factor`, and do not
/// turn.
struct SpaceGrowth {
    std::vector<SpaceLevel> phases;
    double factor = 1;
};

/// Throws Error(ErrorKind::scene) with the reason.
[[nodiscard]] SpaceGrowth find_space_growth(const Grammar& grammar, const SpaceTurns& turns,
                                            const std::string& name);

}  // namespace pxm::host
