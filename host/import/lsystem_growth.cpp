#include "host/import/lsystem_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "host/error.hpp"

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

/// Keeps the displacements within the range of a double.
void rescale(Level& level) {
    double largest = 0;
    for (const Complex& d : level.displacement) largest = std::max(largest, std::abs(d));
    int exponent = 0;
    if (largest > 0 && std::isfinite(largest)) std::frexp(largest, &exponent);
    if (std::abs(exponent) < 100) return;
    for (Complex& d : level.displacement)
        d = {std::ldexp(d.real(), -exponent), std::ldexp(d.imag(), -exponent)};
    level.exponent += exponent;
}

bool same_turn(const TurtleTurn& a, const TurtleTurn& b) {
    constexpr double tolerance = 1e-9;
    constexpr double vanished = 1e-30;  // a step that shrinks or grows at every level gets there
    if (a.step < vanished || a.step > 1 / vanished) return false;
    return a.flip == b.flip && std::abs(std::remainder(a.degrees - b.degrees, 360.0)) < 1e-6 &&
           std::abs(a.step - b.step) <= tolerance * std::max(a.step, b.step);
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

namespace {

constexpr int longest_period = 24;  // levels after which turns and directions must repeat
constexpr std::size_t longest_rules = 65'536;  // commands of all: as many as an ifs has maps
constexpr double settled = 1e-12;              // of the largest displacement

class GrowthSearch {
  public:
    GrowthSearch(const Grammar& grammar, const std::string& name)
        : grammar_(grammar), name_(name), matters_(symbols_that_matter(grammar)) {
        for (std::size_t s = 0; s < grammar.rules.size(); ++s) {
            const char symbol = grammar.rules[s].symbol;
            measured_.push_back(matters_[s] || draws(symbol) || moves(symbol));
        }
    }

    Growth find() {
        run();
        const int turns = period_of_turns();
        for (int period = turns; period <= longest_period; period += turns) {
            if (const auto growth = try_period(period)) return *growth;
        }
        fail(turned_mirrored_ ? "its mirrored copies turn from level to level without an end"
                              : "the lengths of its edges do not settle to a common growth");
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error(ExitCode::scene,
                    fmt::format("L-system \"{}\" has no exact linear fractal: {}", name_, why));
    }

    /// Many levels, of which the last are kept.
    void run() {
        constexpr std::size_t most_commands = 10'000'000;
        std::size_t commands = 1;
        for (const Rule& rule : grammar_.rules) commands += rule.commands.size();
        if (commands > longest_rules)
            fail(fmt::format("its rules have more than {} commands", longest_rules));
        const std::size_t levels = std::clamp<std::size_t>(most_commands / commands, 200, 2000);
        last_.push_back(level_zero(grammar_));
        levels_ = static_cast<int>(levels);
        for (std::size_t n = 0; n < levels; ++n) {
            last_.push_back(next_level(grammar_, last_.back()));
            forget_what_does_not_matter(last_.back());
            if (last_.size() > 2 * longest_period + 1) last_.erase(last_.begin());
            require_displacement(last_.back());
        }
    }

    /// So that it can neither grow out of range nor drive the rest out of it.
    void forget_what_does_not_matter(Level& level) const {
        for (std::size_t s = 0; s < measured_.size(); ++s) {
            if (!matters_[s]) level.turn[s] = {};
            if (!measured_[s]) level.displacement[s] = 0;
        }
        rescale(level);
    }

    void require_displacement(const Level& level) const {
        double largest = 0;
        for (std::size_t s = 0; s < measured_.size(); ++s)
            if (measured_[s]) largest = std::max(largest, std::abs(level.displacement[s]));
        if (!(largest > 1e-9 * std::pow(2.0, -100)) || !std::isfinite(largest))
            fail("its edges are replaced by paths that end where they begin, or vanish");
    }

    /// Level `back` levels before the last.
    [[nodiscard]] const Level& back(int levels) const {
        return last_[last_.size() - 1 - static_cast<std::size_t>(levels)];
    }

    [[nodiscard]] int period_of_turns() const {
        for (int period = 1; period <= longest_period; ++period) {
            const auto repeats = [&](std::size_t s) {
                return !matters_[s] || same_turn(back(0).turn[s], back(period).turn[s]);
            };
            bool all = back(0).drawn == back(period).drawn;
            for (std::size_t s = 0; s < matters_.size(); ++s) all = all && repeats(s);
            if (all) return period;
        }
        fail(
            fmt::format("what comes after its symbols turns, or changes its step, differently at "
                        "every level (tried periods up to {} levels)",
                        longest_period));
    }

    /// The displacements of the last level as multiples of those `period` levels before.
    std::optional<Growth> try_period(int period) {
        const Level& now = back(0);
        const Level& before = back(period);
        const double shift = std::ldexp(1.0, now.exponent - before.exponent);
        std::size_t longest = 0;
        double largest = 0;
        for (std::size_t s = 0; s < measured_.size(); ++s) {
            if (!measured_[s] || std::abs(now.displacement[s]) <= largest) continue;
            longest = s;
            largest = std::abs(now.displacement[s]);
        }
        if (before.displacement[longest] == 0.0) return std::nullopt;
        Complex ratio = now.displacement[longest] / before.displacement[longest];
        for (std::size_t s = 0; s < measured_.size(); ++s) {
            if (!measured_[s]) continue;
            const Complex error = now.displacement[s] - ratio * before.displacement[s];
            if (!(std::abs(error) <= settled * largest)) return std::nullopt;
        }
        ratio *= shift;
        const bool real = std::abs(ratio.imag()) <= settled * std::abs(ratio);
        if (grammar_.has_flips && !(real && (period == 1 || ratio.real() > 0))) {
            turned_mirrored_ = true;
            return std::nullopt;
        }
        if (real) ratio = ratio.real();
        return phases(period, ratio);
    }

    /// factor^period == ratio, |factor|^2 rounded to a whole number if it is one but for rounding.
    static Complex root(Complex ratio, int period) {
        if (period == 1 && ratio.imag() == 0)
            return std::copysign(nice(std::abs(ratio.real())), ratio.real());
        return std::polar(nice(std::pow(std::abs(ratio), 1.0 / period)), std::arg(ratio) / period);
    }
    static double nice(double length) {
        const double square = std::round(length * length);
        return square > 0 && std::abs(length * length - square) < 1e-11 * square ? std::sqrt(square)
                                                                                 : length;
    }

    [[nodiscard]] Growth phases(int period, Complex ratio) const {
        Growth growth;
        growth.factor = root(ratio, period);
        Complex scale{1.0};
        const int first = period + levels_ % period;  // a level whose number is a multiple
        for (int k = 0; k < period; ++k) {
            Level level = back(first - k);
            const double shift = std::ldexp(1.0, level.exponent - back(first).exponent);
            for (Complex& d : level.displacement) d *= shift * scale;
            growth.phases.push_back(std::move(level));
            scale /= growth.factor;
        }
        return growth;
    }

    const Grammar& grammar_;
    const std::string& name_;
    std::vector<char> matters_;
    std::vector<char> measured_;
    std::vector<Level> last_;
    int levels_ = 0;
    bool turned_mirrored_ = false;
};

}  // namespace

Growth find_growth(const Grammar& grammar, const std::string& name) {
    return GrowthSearch(grammar, name).find();
}

}  // namespace pxm::host
