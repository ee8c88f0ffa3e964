#include "host/import/lsystem/space_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/error.hpp"

namespace pxm::host {

namespace {

constexpr int longest_period = 24;  // levels after which turns and directions must repeat
constexpr int most_levels = 260;
constexpr std::size_t longest_rules = 1024;  // commands of all: each is 300 digits at every level
// Of the largest displacement: as of the plane.
constexpr double settled_early = 1e-60, settled = 1e-12;

SpaceState after(const SpaceState& state, const SpaceState& drawing) {
    return {state.turn.then(drawing.turn), state.step * drawing.step};
}

/// Whether the state of a level before has come again; a step that shrinks or grows at every level
/// has not.
bool is_same(const SpaceState& a, const SpaceState& b) {
    const LongReal vanished("1e-30"), tolerance("1e-12");
    if (a.step < vanished || a.step * vanished > 1) return false;
    return abs(LongReal(a.step - b.step)) <= tolerance * a.step && a.turn.is_same(b.turn);
}

SpaceLevel level_zero_in_space(const Grammar& grammar) {
    SpaceLevel level;
    for (const Rule& rule : grammar.rules) {
        const bool steps = draws(rule.symbol) || moves(rule.symbol);
        level.state.emplace_back();
        level.displacement.push_back({steps ? 1 : 0, 0, 0});
        level.drawn.push_back(draws(rule.symbol));
    }
    return level;
}

class SpaceSearch {
  public:
    SpaceSearch(const Grammar& grammar, const SpaceTurns& turns, const std::string& name)
        : grammar_(grammar), turns_(turns), name_(name), matters_(symbols_that_matter(grammar)) {}

    SpaceGrowth find() {
        std::size_t commands = 0;
        for (const Rule& rule : grammar_.rules) commands += rule.commands.size();
        if (commands > longest_rules)
            fail(fmt::format("its rules have more than {} commands in space", longest_rules));
        levels_.push_back(level_zero_in_space(grammar_));
        std::optional<SpaceGrowth> growth;
        while (!growth && static_cast<int>(levels_.size()) <= most_levels) {
            advance();
            const int levels = static_cast<int>(levels_.size()) - 1;
            if (levels > 2 * longest_period && levels % 8 == 0) growth = try_periods(settled_early);
        }
        if (!growth && !repeats_at_all())
            fail(
                fmt::format("what comes after its symbols turns, or changes its step, differently "
                            "at every level (tried periods up to {} levels)",
                            longest_period));
        if (!growth) growth = try_periods(settled);
        if (!growth)
            fail("the lengths of its edges do not settle to a common growth without a turn");
        return std::move(*growth);
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error(ErrorKind::scene,
                    fmt::format("L-system \"{}\" has no exact linear fractal: {}", name_, why));
    }

    void advance() {
        const SpaceLevel& level = levels_.back();
        SpaceLevel next;
        for (const Rule& rule : grammar_.rules) {
            const bool drawn =
                std::ranges::any_of(rule.commands, [&](const TurtleCommand& command) {
                    return command.op == TurtleOp::symbol &&
                           level.drawn[static_cast<std::size_t>(command.symbol)];
                });
            next.drawn.push_back(drawn);
            walk(rule.commands, level, next);
        }
        levels_.push_back(std::move(next));
        for (std::size_t s = 0; s < matters_.size(); ++s) {
            const char symbol = grammar_.rules[s].symbol;
            if (!matters_[s]) levels_.back().state[s] = {};
            if (!matters_[s] && !draws(symbol) && !moves(symbol))
                levels_.back().displacement[s] = {};
        }
        if (largest(levels_.back()) == 0)
            fail("its edges are replaced by paths that end where they begin, or vanish");
    }

    /// From the rule's begin to its end: brackets return to where they began.
    void walk(const std::vector<TurtleCommand>& commands, const SpaceLevel& level,
              SpaceLevel& next) const {
        const LongReal nothing("1e-250");  // of the path's length: what rounding leaves of zero
        SpaceState state;
        LongVec3 place;
        LongReal length{0};
        int depth = 0;
        for (const TurtleCommand& command : commands) {
            if (command.op == TurtleOp::push) ++depth;
            if (command.op == TurtleOp::pop) --depth;
            if (depth > 0 || command.op == TurtleOp::pop) continue;
            if (command.op != TurtleOp::symbol) {
                turns_.apply(command, state);
                continue;
            }
            const auto s = static_cast<std::size_t>(command.symbol);
            const LongVec3 step = state.step * state.turn.of(level.displacement[s]);
            place = place + step;
            length += size(step);
            state = after(state, level.state[s]);
        }
        next.state.push_back(state);
        next.displacement.push_back(size(place) <= nothing * length ? LongVec3{} : place);
    }

    [[nodiscard]] static LongReal largest(const SpaceLevel& level) {
        LongReal most{0};
        for (const LongVec3& d : level.displacement) most = std::max(most, size(d));
        return most;
    }

    [[nodiscard]] const SpaceLevel& back(int levels) const {
        return levels_[levels_.size() - 1 - static_cast<std::size_t>(levels)];
    }

    [[nodiscard]] bool repeats(int period) const {
        if (back(0).drawn != back(period).drawn) return false;
        for (std::size_t s = 0; s < matters_.size(); ++s)
            if (matters_[s] && !is_same(back(0).state[s], back(period).state[s])) return false;
        return true;
    }

    [[nodiscard]] bool repeats_at_all() const {
        for (int period = 1; period <= longest_period; ++period)
            if (repeats(period)) return true;
        return false;
    }

    [[nodiscard]] std::optional<SpaceGrowth> try_periods(double tolerance) const {
        for (int period = 1; period <= longest_period; ++period)
            if (repeats(period))
                if (auto growth = try_period(period, tolerance)) return growth;
        return std::nullopt;
    }

    /// The displacements of the last level as one multiple of those `period` levels before.
    [[nodiscard]] std::optional<SpaceGrowth> try_period(int period, double tolerance) const {
        const SpaceLevel &now = back(0), &before = back(period);
        const LongReal most = largest(now), then = largest(before);
        const LongReal ratio = most / then;
        for (std::size_t s = 0; s < now.displacement.size(); ++s)
            if (size(now.displacement[s] - ratio * before.displacement[s]) >
                LongReal(tolerance) * most)
                return std::nullopt;
        return phases(period, nice_root(ratio.convert_to<double>(), period));
    }

    /// A whole number, or the root of one, where it is that up to rounding.
    static double nice_root(double ratio, int period) {
        const double factor = std::pow(ratio, 1.0 / period);
        const double square = std::round(factor * factor);
        return square > 0 && std::abs(factor * factor - square) < 1e-11 * square ? std::sqrt(square)
                                                                                 : factor;
    }

    [[nodiscard]] SpaceGrowth phases(int period, double factor) const {
        SpaceGrowth growth;
        growth.factor = factor;
        const int last = static_cast<int>(levels_.size()) - 1;
        const int first = period + last % period;  // back to a level whose number is a multiple
        const LongReal longest = largest(back(first));
        LongReal scale{1};
        for (int k = 0; k < period; ++k) {
            SpaceLevel level = back(first - k);
            for (LongVec3& d : level.displacement) d = LongReal(scale / longest) * d;
            growth.phases.push_back(std::move(level));
            scale /= LongReal(factor);
        }
        return growth;
    }

    const Grammar& grammar_;
    const SpaceTurns& turns_;
    const std::string& name_;
    std::vector<char> matters_;
    std::vector<SpaceLevel> levels_;
};

}  // namespace

SpaceTurns::SpaceTurns(const Lsystem& lsystem)
    : step_(lsystem.degrees.empty() ? fmt::format("/{:.17g}", lsystem.steps_a_turn)
                                    : lsystem.degrees) {}

const SpaceTurn& SpaceTurns::turn(int axis, const std::string& degrees) const {
    const auto [place, added] = known_.try_emplace({axis, degrees});
    if (added) {
        const bool parts = degrees.starts_with('/');
        const LongReal number(parts ? degrees.substr(1) : degrees);
        place->second = SpaceTurn(axis, parts ? LongReal(360 / number) : number);
    }
    return place->second;
}

void SpaceTurns::apply(const TurtleCommand& command, SpaceState& state) const {
    const std::string& written = command.factor.decimal;
    const auto by = [&](int axis) {
        const std::string degrees = written.empty() ? step_ : written;
        const bool back = command.value < 0;
        SpaceTurn turned = turn(axis, degrees);
        if (back) turned = turned.inverse();
        state.turn = state.turn.then(turned);
    };
    switch (command.op) {
        case TurtleOp::turn:
            return by(2);
        case TurtleOp::pitch:
            return by(1);
        case TurtleOp::roll:
            return by(0);
        case TurtleOp::round:
            state.turn = state.turn.then(turn(2, "180"));
            return;
        case TurtleOp::step:
            state.step *= value_of(command.factor);
            return;
        case TurtleOp::turn_degrees:
        case TurtleOp::flip:
        case TurtleOp::symbol:
        case TurtleOp::push:
        case TurtleOp::pop:
            return;
    }
}

std::vector<SpaceOccurrence> space_occurrences(const std::vector<TurtleCommand>& commands,
                                               const SpaceTurns& turns, const SpaceLevel& level) {
    struct Walker {
        SpaceState state;
        LongVec3 place;
    };
    std::vector<SpaceOccurrence> list;
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
            list.push_back({command.symbol, turtle.state, to_double(turtle.place)});
            turtle.place =
                turtle.place + turtle.state.step * turtle.state.turn.of(level.displacement[s]);
            turtle.state = after(turtle.state, level.state[s]);
        } else {
            turns.apply(command, turtle.state);
        }
    }
    return list;
}

SpaceGrowth find_space_growth(const Grammar& grammar, const SpaceTurns& turns,
                              const std::string& name) {
    return SpaceSearch(grammar, turns, name).find();
}

}  // namespace pxm::host
