// Levels until the rules repeat and all lengths grow by a common factor.
#include "host/import/lsystem_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/error.hpp"

namespace pxm::host {
namespace {

using Complex = std::complex<double>;

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
        constexpr std::size_t most_commands = 3'000'000;
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
