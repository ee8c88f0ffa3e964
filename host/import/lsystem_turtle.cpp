// The turtle over the words of an L-system, one level at a time.
#include "host/import/lsystem_growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pxm::host {
namespace {

using Complex = std::complex<double>;

/// A turtle that walks over drawings: position, heading, mirror, step.
struct Walker {
    TurtleTurn turn;
    Complex place{0.0};
};

double normalized(double degrees, double step_degrees) {
    double turned = std::remainder(degrees, 360.0);
    constexpr double near = 1e-6;  // rounding of sums of turns is far below, odd turns far above
    for (const double unit : {step_degrees, 1e-3}) {
        if (unit <= 0) continue;
        const double steps = std::round(turned / unit);
        if (std::abs(turned - steps * unit) < near * unit) turned = steps * unit;
    }
    return turned <= -180 + near ? turned + 360 : turned;
}

Complex direction(double degrees) {
    const double quarter = std::remainder(degrees, 90.0);
    if (quarter == 0.0) {
        const int quarters = (static_cast<int>(std::lround(degrees / 90.0)) % 4 + 4) % 4;
        constexpr std::array<Complex, 4> axes{Complex{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        return axes[static_cast<std::size_t>(quarters)];
    }
    return std::polar(1.0, degrees * std::numbers::pi / 180);
}

/// The turn of a drawing, done by a turtle that has turned already.
TurtleTurn after(const TurtleTurn& turn, const TurtleTurn& drawing, double step_degrees) {
    return {normalized(turn.degrees + (turn.flip ? -1 : 1) * drawing.degrees, step_degrees),
            turn.flip != drawing.flip, turn.step * drawing.step};
}

template <class OnSymbol>
Walker walk(const std::vector<TurtleCommand>& commands, double step_degrees, const Level& level,
            const OnSymbol& on_symbol) {
    Walker turtle;
    std::vector<Walker> stack;
    for (const TurtleCommand& command : commands) {
        TurtleTurn& turn = turtle.turn;
        switch (command.op) {
            case TurtleOp::symbol: {
                const auto s = static_cast<std::size_t>(command.symbol);
                on_symbol(static_cast<int>(s), turtle);
                const Complex d = level.displacement[s];
                turtle.place +=
                    turn.step * direction(turn.degrees) * (turn.flip ? std::conj(d) : d);
                turn = after(turn, level.turn[s], step_degrees);
                break;
            }
            case TurtleOp::turn:
                turn = after(turn, {command.value, false, 1}, step_degrees);
                break;
            case TurtleOp::round:
                turn.degrees = normalized(turn.degrees + command.value, step_degrees);
                break;
            case TurtleOp::flip:
                turn.flip = !turn.flip;
                break;
            case TurtleOp::step:
                turn.step *= command.value;
                break;
            case TurtleOp::push:
                stack.push_back(turtle);
                break;
            case TurtleOp::pop:
                turtle = stack.back();
                stack.pop_back();
                break;
        }
    }
    return turtle;
}

}  // namespace

bool draws(char symbol) { return symbol == 'f' || symbol == 'd'; }
bool moves(char symbol) { return symbol == 'g' || symbol == 'm'; }

Grammar grammar_of(const Lsystem& lsystem) {
    Grammar grammar;
    grammar.step_degrees = lsystem.step_degrees;
    std::map<char, int> index;
    const auto numbered = [&](std::vector<TurtleCommand> commands) {
        for (TurtleCommand& command : commands) {
            if (command.op == TurtleOp::flip) grammar.has_flips = true;
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
        const std::vector<TurtleCommand> itself{{TurtleOp::symbol, symbol, 0}};
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
        level.displacement.emplace_back(steps ? 1.0 : 0.0);
        level.drawn.push_back(draws(rule.symbol));
    }
    return level;
}

Level next_level(const Grammar& grammar, const Level& level) {
    Level next;
    next.exponent = level.exponent;
    for (const Rule& rule : grammar.rules) {
        char drawn = 0;
        const Walker end =
            walk(rule.commands, grammar.step_degrees, level,
                 [&](int s, const Walker&) { drawn |= level.drawn[static_cast<std::size_t>(s)]; });
        next.turn.push_back(end.turn);
        next.displacement.push_back(end.place);
        next.drawn.push_back(drawn);
    }
    return next;
}

std::vector<Occurrence> occurrences(const std::vector<TurtleCommand>& commands, double step_degrees,
                                    const Level& level) {
    std::vector<Occurrence> list;
    walk(commands, step_degrees, level, [&](int s, const Walker& turtle) {
        list.push_back({s, turtle.turn, turtle.place});
    });
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
