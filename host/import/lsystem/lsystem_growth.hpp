// How the words of an L-system grow: what a symbol's drawing does to the turtle, level by level.
#pragma once

#include <complex>
#include <cstdint>
#include <vector>

#include "host/import/lsystem/compass.hpp"
#include "host/import/lsystem/long_number.hpp"
#include "host/import/lsystem/lsystem.hpp"

namespace pxm::host {

/// What the turtle's state becomes by a symbol's drawing, the position left out.
struct TurtleTurn {
    std::int64_t direction = 0;  // of the grammar's compass
    bool flip = false;
    LongReal step{1};
};

/// An occurrence of a symbol in a rule: where the turtle stands and how, when it comes to it.
struct Occurrence {
    int symbol = 0;
    TurtleTurn turn;
    std::complex<double> place{0.0};
};

/// A rule with its symbols as indices.
struct Rule {
    char symbol = 0;
    bool constant = false;                // the symbol itself and nothing else
    std::vector<TurtleCommand> commands;  // TurtleCommand::symbol holds the index
};

/// The symbols that the axiom leads to, each with its rule.
struct Grammar {
    std::vector<Rule> rules;
    std::vector<TurtleCommand> axiom;
    Compass compass{2};
    bool has_flips = false;
    bool has_decimals = false;  // factors or degrees, which may stand for other numbers
};
[[nodiscard]] Grammar grammar_of(const Lsystem& lsystem);

[[nodiscard]] LongReal value_of(const StepFactor& factor);

/// What is known of every symbol at one level. Displacements are those of a turtle that starts to
/// the right with step 1; one that is not known from zero is zero.
struct Level {
    std::vector<TurtleTurn> turn;
    std::vector<LongComplex> displacement;
    std::vector<long double> noise;  // no displacement is off by more
    std::vector<char> drawn;         // something of it is drawn
};
[[nodiscard]] Level level_zero(const Grammar& grammar);
[[nodiscard]] Level next_level(const Grammar& grammar, const Level& level);

/// The symbols of a rule as the turtle finds them, if their drawings are those of `level`.
[[nodiscard]] std::vector<Occurrence> occurrences(const std::vector<TurtleCommand>& commands,
                                                  const Compass& compass, const Level& level);

/// Symbols whose turn and displacement move something that comes after them.
[[nodiscard]] std::vector<char> symbols_that_matter(const Grammar& grammar);

/// The levels of one period, once the rules repeat: phases[k] is level n0 + k, n0 a
/// multiple of the period.
struct LsystemGrowth {
    std::vector<Level> phases;         // as of a limit (see `factor`), the longest of the first 1
    std::complex<double> factor{1.0};  // of all lengths from one level to the next
};

/// Throws Error(ErrorKind::scene) with the reason if lengths do not settle to a common growth.
[[nodiscard]] LsystemGrowth find_growth(const Grammar& grammar, const std::string& name);

}  // namespace pxm::host
