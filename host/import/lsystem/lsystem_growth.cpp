// Levels until the rules repeat and all lengths grow by a common factor.
#include "host/import/lsystem/lsystem_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/error.hpp"

namespace pxm::host {
namespace {

using Complex = std::complex<double>;

bool same_turn(const TurtleTurn& a, const TurtleTurn& b) {
    const LongReal tolerance(1e-9);
    const LongReal vanished(1e-30);  // a step that shrinks or grows at every level gets there
    if (a.step < vanished || a.step > 1 / vanished) return false;
    return a.flip == b.flip && a.direction == b.direction &&
           abs(LongReal(a.step - b.step)) <= tolerance * std::max(a.step, b.step);
}

constexpr int longest_period = 24;  // levels after which turns and directions must repeat
constexpr int first_looked_at = 2 * longest_period + 1;
// Turns are numbers modulo a turn of fewer than 2^62 parts, of which a level is a linear function:
// where they repeat, they do so after some 62 levels a symbol at the most, and mostly at once.
constexpr int last_to_begin_a_period = 256;
constexpr std::size_t longest_rules = 65'536;  // commands of all: as many as an ifs has maps
// Of the largest displacement: what others may be off by where they have settled beyond doubt, and
// where no more levels are looked at.
constexpr double settled_early = 1e-60;
constexpr double settled = 1e-12;

class GrowthSearch {
  public:
    GrowthSearch(const Grammar& grammar, const std::string& name)
        : grammar_(grammar), name_(name), matters_(symbols_that_matter(grammar)) {
        for (std::size_t s = 0; s < grammar.rules.size(); ++s) {
            const char symbol = grammar.rules[s].symbol;
            measured_.push_back(matters_[s] || draws(symbol) || moves(symbol));
        }
    }

    LsystemGrowth find() {
        const int most_levels = begin();
        int next_look = first_looked_at;
        std::optional<LsystemGrowth> growth;
        while (!growth && levels_ < most_levels && decided()) {
            while (levels_ < next_look && decided()) advance();
            next_look += next_look / 8;
            growth = try_periods(settled_early);
            if (levels_ > last_to_begin_a_period && !period_of_turns()) break;
        }
        if (!growth && !period_of_turns())
            fail(levels_ < longest_period
                     ? "after a few levels its edges are no longer than what rounding makes of them"
                     : fmt::format("what comes after its symbols turns, or changes its step, "
                                   "differently at every level (tried periods up to {} levels)",
                                   longest_period));
        if (!growth) growth = try_periods(settled);
        if (!growth)
            fail(turned_mirrored_ ? "its mirrored copies turn from level to level without an end"
                                  : "the lengths of its edges do not settle to a common growth");
        if (grammar_.has_decimals && !grows_from_the_start(std::abs(growth->factor)))
            fail(
                "its edges come to a common growth only by what the decimals of its factors or "
                "turns are off");
        return std::move(*growth);
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error(ErrorKind::scene,
                    fmt::format("L-system \"{}\" has no exact linear fractal: {}", name_, why));
    }

    /// Level zero. Returns how many levels are looked at if nothing settles earlier.
    int begin() {
        constexpr std::size_t most_commands = 3'000'000;
        if (grammar_.rules.empty()) fail("its axiom turns the turtle and draws nothing");
        std::size_t commands = 1;
        for (const Rule& rule : grammar_.rules) commands += rule.commands.size();
        if (commands > longest_rules)
            fail(fmt::format("its rules have more than {} commands", longest_rules));
        last_.push_back(level_zero(grammar_));
        sizes_.push_back(size_of_last());
        return static_cast<int>(std::clamp<std::size_t>(most_commands / commands, 200, 2000));
    }

    /// The next level; of those before, as many are kept as are looked at.
    void advance() {
        last_.push_back(next_level(grammar_, last_.back()));
        forget_what_does_not_matter(last_.back());
        if (last_.size() > 2 * longest_period + 1) last_.erase(last_.begin());
        ++levels_;
        if (largest_displacement() == 0)
            fail("its edges are replaced by paths that end where they begin, or vanish");
        sizes_.push_back(size_of_last());
    }

    /// The binary logarithm, rounded down.
    [[nodiscard]] double size_of_last() const {
        const LongReal largest = largest_displacement();
        return largest == 0 ? 0 : static_cast<double>(ilogb(largest));
    }

    /// A system whose decimals stand for others, as .7071 for a root of 1/2, can be near one whose
    /// strokes do not have its largest growth. Then that begins thousands of times too small.
    [[nodiscard]] bool grows_from_the_start(double factor) const {
        constexpr double too_small = 10;  // binary digits
        double most = sizes_.front();
        for (std::size_t n = 0; n < std::min<std::size_t>(first_looked_at, sizes_.size()); ++n)
            most = std::max(most, sizes_[n] - static_cast<double>(n) * std::log2(factor));
        return sizes_.back() - levels_ * std::log2(factor) > most - too_small;
    }

    /// So that it cannot drive the rest out of range.
    void forget_what_does_not_matter(Level& level) const {
        for (std::size_t s = 0; s < measured_.size(); ++s) {
            if (!matters_[s]) level.turn[s] = {};
            if (measured_[s]) continue;
            level.displacement[s] = {};
            level.noise[s] = 0;
        }
    }

    [[nodiscard]] LongReal largest_displacement() const {
        LongReal largest{0};
        for (const LongComplex& d : back(0).displacement) largest = std::max(largest, size(d));
        return largest;
    }

    /// Whether rounding is far below the largest displacement.
    [[nodiscard]] bool decided() const {
        constexpr long double far_below = 1e-20L;
        const long double noise = *std::ranges::max_element(back(0).noise);
        return std::isfinite(noise) && LongReal(noise) <= far_below * largest_displacement();
    }

    /// Level `levels` levels before the last: no more than there were, nor than are kept.
    [[nodiscard]] const Level& back(int levels) const {
        return last_[last_.size() - 1 - static_cast<std::size_t>(levels)];
    }

    /// After so many levels turns and directions repeat.
    [[nodiscard]] std::optional<int> period_of_turns() const {
        for (int period = 1; period <= std::min(longest_period, levels_); ++period) {
            const auto repeats = [&](std::size_t s) {
                return !matters_[s] || same_turn(back(0).turn[s], back(period).turn[s]);
            };
            bool all = back(0).drawn == back(period).drawn;
            for (std::size_t s = 0; s < matters_.size(); ++s) all = all && repeats(s);
            if (all) return period;
        }
        return std::nullopt;
    }

    std::optional<LsystemGrowth> try_periods(double tolerance) {
        const int turns = period_of_turns().value_or(longest_period + 1);
        for (int period = turns; period <= std::min(longest_period, levels_); period += turns) {
            if (const auto growth = try_period(period, tolerance)) return growth;
        }
        return std::nullopt;
    }

    /// The displacements of the last level as multiples of those `period` levels before.
    std::optional<LsystemGrowth> try_period(int period, double tolerance) {
        const Level& now = back(0);
        const Level& before = back(period);
        std::size_t longest = 0;
        for (std::size_t s = 0; s < measured_.size(); ++s)
            if (size(now.displacement[s]) > size(now.displacement[longest])) longest = s;
        if (size(before.displacement[longest]) == 0) return std::nullopt;
        const LongComplex ratio = now.displacement[longest] / before.displacement[longest];
        const LongReal most = LongReal(tolerance) * size(now.displacement[longest]);
        for (std::size_t s = 0; s < measured_.size(); ++s)
            if (!(size(now.displacement[s] - ratio * before.displacement[s]) <= most))
                return std::nullopt;
        Complex factor = to_double(ratio);
        const bool real = std::abs(factor.imag()) <= settled * std::abs(factor);
        if (grammar_.has_flips && !(real && (period == 1 || factor.real() > 0))) {
            turned_mirrored_ = true;
            return std::nullopt;
        }
        if (real) factor = factor.real();
        return phases(period, factor);
    }

    /// factor^period == ratio, |factor|^2 made a whole number if it is one up to rounding.
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

    [[nodiscard]] LsystemGrowth phases(int period, Complex ratio) const {
        LsystemGrowth growth;
        growth.factor = root(ratio, period);
        Complex scale{1.0};
        const int first = period + levels_ % period;  // a level whose number is a multiple
        LongReal longest{0};
        for (const LongComplex& d : back(first).displacement) longest = std::max(longest, size(d));
        for (int k = 0; k < period; ++k) {
            Level level = back(first - k);
            for (LongComplex& d : level.displacement)
                d = LongReal(1 / longest) * (long_complex(scale) * d);
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
    std::vector<double> sizes_;  // of every level
    int levels_ = 0;
    bool turned_mirrored_ = false;
};

}  // namespace

LsystemGrowth find_growth(const Grammar& grammar, const std::string& name) {
    return GrowthSearch(grammar, name).find();
}

}  // namespace pxm::host
