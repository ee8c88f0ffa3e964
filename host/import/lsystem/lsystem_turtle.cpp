// The turtle over the words of an L-system, one level at a time.
#include "host/import/lsystem/lsystem_growth.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace pxm::host {
namespace {

/// A turtle that walks over drawings: position, heading, mirror, step.
struct Walker {
    TurtleTurn turn;
    LongComplex place;
};

/// The turn of a drawing, done by a turtle that has turned already.
TurtleTurn after(const TurtleTurn& turn, const TurtleTurn& drawing, const Compass& compass) {
    const std::int64_t turned = turn.flip ? compass.opposite(drawing.direction) : drawing.direction;
    return {compass.sum(turn.direction, turned), turn.flip != drawing.flip,
            drawing.step == 1 ? turn.step : LongReal(turn.step * drawing.step)};
}

/// What a command other than a symbol or a bracket does to the turtle.
void turn_by(const TurtleCommand& command, const Compass& compass, TurtleTurn& turn) {
    switch (command.op) {
        case TurtleOp::turn:
            turn = after(turn, {compass.of_steps(command.value), false, 1}, compass);
            break;
        case TurtleOp::turn_degrees:
            turn = after(turn, {compass.of_degrees(command.value), false, 1}, compass);
            break;
        case TurtleOp::round:
            turn.direction = compass.sum(turn.direction, compass.of_steps(command.value));
            break;
        case TurtleOp::flip:
            turn.flip = !turn.flip;
            break;
        case TurtleOp::step:
            turn.step *= value_of(command.factor);
            break;
        case TurtleOp::pitch:  // of space alone
        case TurtleOp::roll:
        case TurtleOp::symbol:
        case TurtleOp::push:
        case TurtleOp::pop:
            break;
    }
}

LongComplex carried(const TurtleTurn& turn, const Compass& compass, const LongComplex& d) {
    return turn.step * (compass.vector(turn.direction) * (turn.flip ? conj(d) : d));
}

/// A symbol as the turtle comes to it, and how often it does so in the same state.
struct Passed {
    int symbol = 0;
    TurtleTurn turn;

    friend bool operator<(const Passed& a, const Passed& b) {
        return std::tie(a.symbol, a.turn.direction, a.turn.flip, a.turn.step) <
               std::tie(b.symbol, b.turn.direction, b.turn.flip, b.turn.step);
    }
};
struct Passage {
    std::map<Passed, long> passed;
    TurtleTurn end;
};

/// What moves the turtle from its begin to its end: brackets return to where they began.
Passage pass(const std::vector<TurtleCommand>& commands, const Compass& compass,
             const Level& level) {
    Passage passage;
    int depth = 0;
    for (const TurtleCommand& command : commands) {
        if (command.op == TurtleOp::push) ++depth;
        if (command.op == TurtleOp::pop) --depth;
        if (depth > 0) continue;
        if (command.op == TurtleOp::symbol) {
            ++passage.passed[{command.symbol, passage.end}];
            passage.end =
                after(passage.end, level.turn[static_cast<std::size_t>(command.symbol)], compass);
        } else {
            turn_by(command, compass, passage.end);
        }
    }
    return passage;
}

/// The displacement of a passage, zero if rounding may have made all of it, and what is off by.
void displace(const Passage& passage, const Compass& compass, const Level& level, Level& next) {
    constexpr long double sure = 1 << 20;
    const long double rounding =
        64 * std::numeric_limits<LongReal>::epsilon().convert_to<long double>();
    LongComplex sum;
    long double noise = 0;
    for (const auto& [passed, times] : passage.passed) {
        const auto s = static_cast<std::size_t>(passed.symbol);
        const LongComplex& d = level.displacement[s];
        sum = sum + LongReal(times) * carried(passed.turn, compass, d);
        noise += static_cast<long double>(times) * passed.turn.step.convert_to<long double>() *
                 (level.noise[s] + rounding * size(d).convert_to<long double>());
    }
    const bool nothing = size(sum) <= LongReal(sure * noise);
    next.displacement.push_back(nothing ? LongComplex{} : sum);
    next.noise.push_back(noise);
}

}  // namespace

LongReal value_of(const StepFactor& factor) {
    LongReal value(factor.decimal);
    if (factor.root) value = sqrt(value);
    return factor.inverse ? LongReal(1 / value) : value;
}

bool draws(char symbol) { return symbol == 'f' || symbol == 'd'; }
bool moves(char symbol) { return symbol == 'g' || symbol == 'm'; }

Grammar grammar_of(const Lsystem& lsystem) {
    Grammar grammar;
    grammar.compass = Compass(lsystem.steps_a_turn);
    std::map<char, int> index;
    const auto numbered = [&](std::vector<TurtleCommand> commands) {
        for (TurtleCommand& command : commands) {
            if (command.op == TurtleOp::flip) grammar.has_flips = true;
            if (command.op == TurtleOp::step || command.op == TurtleOp::turn_degrees)
                grammar.has_decimals = true;
            if (command.op != TurtleOp::symbol) continue;
            const auto [found, added] =
                index.emplace(command.symbol, static_cast<int>(grammar.rules.size()));
            if (added) grammar.rules.push_back({command.symbol, false, {}});
            command.symbol = static_cast<char>(found->second);
        }
        return commands;
    };
    grammar.axiom = numbered(lsystem.axiom);
    for (std::size_t s = 0; s < grammar.rules.size(); ++s) {
        const char symbol = grammar.rules[s].symbol;
        const auto rule = lsystem.rules.find(symbol);
        const std::vector<TurtleCommand> itself{{TurtleOp::symbol, symbol, 0, {}}};
        auto commands = numbered(rule == lsystem.rules.end() ? itself : rule->second);
        const bool constant = commands.size() == 1 && commands[0].op == TurtleOp::symbol &&
                              static_cast<std::size_t>(commands[0].symbol) == s;
        grammar.rules[s].commands = std::move(commands);
        grammar.rules[s].constant = constant;
    }
    return grammar;
}

Level level_zero(const Grammar& grammar) {
    Level level;
    for (const Rule& rule : grammar.rules) {
        const bool steps = draws(rule.symbol) || moves(rule.symbol);
        level.turn.emplace_back();
        level.displacement.push_back({steps ? 1 : 0, 0});
        level.noise.push_back(0);
        level.drawn.push_back(draws(rule.symbol));
    }
    return level;
}

Level next_level(const Grammar& grammar, const Level& level) {
    Level next;
    for (const Rule& rule : grammar.rules) {
        const Passage passage = pass(rule.commands, grammar.compass, level);
        displace(passage, grammar.compass, level, next);
        next.turn.push_back(passage.end);
        next.drawn.push_back(std::ranges::any_of(rule.commands, [&](const TurtleCommand& command) {
            return command.op == TurtleOp::symbol &&
                   level.drawn[static_cast<std::size_t>(command.symbol)];
        }));
    }
    return next;
}

std::vector<Occurrence> occurrences(const std::vector<TurtleCommand>& commands,
                                    const Compass& compass, const Level& level) {
    std::vector<Occurrence> list;
    Walker turtle;
    std::vector<Walker> stack;
    for (const TurtleCommand& command : commands) {
        if (command.op == TurtleOp::push) {
            stack.push_back(turtle);
        } else if (command.op == TurtleOp::pop) {
            turtle = stack.back();
            stack.pop_back();
        } else if (command.op == TurtleOp::symbol) {
            const auto s = static_cast<std::size_t>(command.symbol);
            list.push_back({command.symbol, turtle.turn, to_double(turtle.place)});
            turtle.place = turtle.place + carried(turtle.turn, compass, level.displacement[s]);
            turtle.turn = after(turtle.turn, level.turn[s], compass);
        } else {
            turn_by(command, compass, turtle.turn);
        }
    }
    return list;
}

namespace {

/// Symbols in whose words there is, at some level, a step.
std::vector<char> stepping_symbols(const Grammar& grammar) {
    std::vector<char> steps;
    for (const Rule& rule : grammar.rules)
        steps.push_back(draws(rule.symbol) || moves(rule.symbol));
    const auto contains_step = [&](const Rule& rule) {
        return std::ranges::any_of(rule.commands, [&](const TurtleCommand& command) {
            return command.op == TurtleOp::symbol &&
                   steps[static_cast<std::size_t>(command.symbol)];
        });
    };
    for (std::vector<char> before; before != steps;) {
        before = steps;
        for (std::size_t s = 0; s < steps.size(); ++s)
            if (contains_step(grammar.rules[s])) steps[s] = 1;
    }
    return steps;
}

/// Marks the symbols of a rule that something in their scope comes after.
void mark(const std::vector<TurtleCommand>& commands, bool end_matters,
          const std::vector<char>& steps, std::vector<char>& matters) {
    bool later = end_matters;
    std::vector<bool> outside;
    for (auto command = commands.rbegin(); command != commands.rend(); ++command) {
        if (command->op == TurtleOp::pop) {  // read backwards, a pop opens the bracket
            outside.push_back(later);
            later = false;
        } else if (command->op == TurtleOp::push) {
            later = later || outside.back();
            outside.pop_back();
        } else if (command->op == TurtleOp::symbol) {
            const auto s = static_cast<std::size_t>(command->symbol);
            if (later) matters[s] = 1;
            if (steps[s]) later = true;
        }
    }
}

}  // namespace

std::vector<char> symbols_that_matter(const Grammar& grammar) {
    const std::vector<char> steps = stepping_symbols(grammar);
    std::vector<char> matters(grammar.rules.size(), 0);
    for (std::vector<char> before; before != matters;) {
        before = matters;
        mark(grammar.axiom, false, steps, matters);
        for (std::size_t s = 0; s < matters.size(); ++s)
            mark(grammar.rules[s].commands, matters[s] != 0, steps, matters);
    }
    return matters;
}

}  // namespace pxm::host
