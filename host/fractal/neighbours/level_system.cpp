#include "host/fractal/neighbours/level_system.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

namespace pxm::host {

namespace {

using exact::Algebraic;
using exact::ExactMap;
using exact::Polynomial;

constexpr int most_power = 12;

Algebraic lifted(const exact::ExactSystem& system, const Polynomial& p) {
    Algebraic a = system.numbers.lifted(exact::whole(0));
    a.value = p;
    return a;
}

/// The smallest whole numbers that the logarithms of the ratios are as, which are then verified.
std::vector<int> powers_of(const exact::ExactSystem& system) {
    std::vector<double> logs;
    for (const Polynomial& square : system.squared_ratio)
        logs.push_back(-std::log(system.numbers.approximate(lifted(system, square))));
    const double least = *std::ranges::min_element(logs);
    for (int of_least = 1; of_least <= most_power; ++of_least) {
        std::vector<int> powers;
        bool near = true;
        for (const double log : logs) {
            constexpr double close = 1e-9;
            const double power = log / least * of_least;
            powers.push_back(static_cast<int>(std::lround(power)));
            near = near && std::abs(power - powers.back()) < close * power &&
                   powers.back() <= most_power;
        }
        if (near) return powers;
    }
    return {};
}

Polynomial power(const exact::ExactSystem& system, const Polynomial& base, int exponent) {
    Algebraic result = system.numbers.lifted(exact::whole(1));
    for (int i = 0; i < std::abs(exponent); ++i)
        result = system.numbers.multiply(result, lifted(system, base));
    if (exponent < 0)
        result = system.numbers.divide(system.numbers.lifted(exact::whole(1)), result);
    return result.value;
}

/// Whole numbers whose products with `powers` add up to 1. Precondition: these have no common
/// factor.
std::vector<int> shares_of_one(const std::vector<int>& powers) {
    std::vector<int> shares(powers.size(), 0);
    int sum = 0;  // of powers times shares: the greatest common divisor so far
    for (std::size_t i = 0; i < powers.size(); ++i) {
        // sum * a + powers[i] * b = the next divisor
        int a = 1, b = 0, x = 0, y = 1, r = sum, s = powers[i];
        while (s != 0) {
            const int q = r / s;
            r = std::exchange(s, r - q * s);
            a = std::exchange(x, a - q * x);
            b = std::exchange(y, b - q * y);
        }
        for (int& share : shares) share *= a;
        shares[i] = b;
        sum = r;
    }
    return shares;
}

/// A similitude in both numbers.
struct Similitude {
    ExactMap map;
    ExactMap inverse;
    Affine rounded;
    Affine rounded_inverse;
};

class Levels {
  public:
    Levels(const exact::ExactSystem& system, const Rifs& rifs, const Bounds& bounds,
           std::vector<int> powers)
        : system_(system), rifs_(rifs), bounds_(bounds), powers_(std::move(powers)) {}

    std::optional<LevelSystem> run() {
        const std::vector<int> shares = shares_of_one(powers_);
        Polynomial square(1);
        for (std::size_t m = 0; m < shares.size(); ++m)
            square =
                system_.numbers
                    .multiply(lifted(system_, square),
                              lifted(system_, power(system_, system_.squared_ratio[m], shares[m])))
                    .value;
        for (std::size_t m = 0; m < powers_.size(); ++m)
            if (!(power(system_, square, powers_[m]) == system_.squared_ratio[m]))
                return std::nullopt;
        const Similitude unit = unit_of(shares);
        begin(square);
        for (std::size_t m = 0; m < powers_.size(); ++m) add(m, unit);
        // The whole's own maps stand first in each chain.
        result_.rifs.follow_sets[0].maps = firsts_;
        return std::move(result_);
    }

  private:
    [[nodiscard]] Similitude then_inner(const Similitude& outer, const Similitude& inner) const {
        return {ExactMap::composed(system_.field, outer.map, inner.map),
                ExactMap::composed(system_.field, inner.inverse, outer.inverse),
                then(inner.rounded, outer.rounded),
                then(outer.rounded_inverse, inner.rounded_inverse)};
    }

    [[nodiscard]] Similitude of_map(std::size_t m) const {
        return {system_.maps[m], system_.inverses[m], rifs_.maps[m], inverse(rifs_.maps[m])};
    }

    static Similitude inverse_of(const Similitude& s) {
        return {s.inverse, s.map, s.rounded_inverse, s.rounded};
    }

    /// A product of the maps and their inverses whose ratio is the unit of all.
    [[nodiscard]] Similitude unit_of(const std::vector<int>& shares) const {
        const ExactMap identity = ExactMap::identity(system_.field);
        Similitude unit{identity, identity, {}, {}};
        for (std::size_t m = 0; m < shares.size(); ++m) {
            const Similitude map = of_map(m);
            for (int i = 0; i < std::abs(shares[m]); ++i)
                unit = then_inner(unit, shares[m] > 0 ? map : inverse_of(map));
        }
        return unit;
    }

    void begin(const Polynomial& square) {
        exact::ExactSystem& system = result_.system;
        system.field = system_.field;
        system.axes = system_.axes;
        system.along_axes = system_.along_axes;
        system.equal_ratios = true;
        constexpr double doubt = 1e-8;  // of balls that were moved by rounded maps
        system.offset = std::max(doubt, system_.offset);
        result_.log_ratio = std::log(system_.numbers.approximate(lifted(system_, square))) / 2;
        result_.rifs.follow_sets.emplace_back();
        result_.bounds.push_back(bounds_);
    }

    int add_map(const Similitude& map, int follow) {
        result_.system.maps.push_back(map.map);
        result_.system.inverses.push_back(map.inverse);
        result_.rifs.maps.push_back(map.rounded);
        result_.rifs.follow_of.push_back(follow);
        return static_cast<int>(result_.rifs.maps.size()) - 1;
    }

    /// The chain of a map: units, and what is left of the map at the end.
    void add(std::size_t m, const Similitude& unit) {
        Similitude rest = of_map(m);
        int from = 0;  // the follow set that the next map is of
        for (int left = powers_[m]; left > 1; --left) {
            rest = then_inner(inverse_of(unit), rest);
            const int waiting = static_cast<int>(result_.rifs.follow_sets.size());
            place(add_map(unit, waiting), from);
            result_.rifs.follow_sets.emplace_back();
            result_.bounds.push_back(moved(rest.rounded));
            from = waiting;
        }
        place(add_map(rest, 0), from);
    }

    void place(int map, int set) {
        if (set == 0) {
            firsts_.push_back(map);
        } else {
            result_.rifs.follow_sets[static_cast<std::size_t>(set)].maps.push_back(map);
        }
    }

    /// The ball alone: a similitude takes a ball to a ball.
    [[nodiscard]] Bounds moved(const Affine& map) const {
        Bounds result = bounds_;
        result.ball.center = map.point(bounds_.ball.center);
        result.ball.radius = bounds_.ball.radius * std::cbrt(std::abs(determinant(map)));
        return result;
    }

    const exact::ExactSystem& system_;
    const Rifs& rifs_;
    const Bounds& bounds_;
    std::vector<int> powers_;
    std::vector<int> firsts_;
    LevelSystem result_;
};

/// Similitudes of space, whose inverses in double are good.
bool are_plain(const Rifs& rifs) {
    return std::ranges::all_of(rifs.maps, [](const Affine& map) {
        constexpr double close = 1e-9;
        const double ratio = std::cbrt(std::abs(determinant(map)));
        if (!(ratio > 0)) return false;
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(glm::length(map.linear[i]) - ratio) < close * ratio)) return false;
        return true;
    });
}

}  // namespace

std::optional<LevelSystem> level_system(const exact::ExactSystem& system, const Rifs& rifs,
                                        const Bounds& bounds) {
    if (!are_plain(rifs)) return std::nullopt;
    const std::vector<int> powers = powers_of(system);
    const int common = std::accumulate(powers.begin(), powers.end(), 0,
                                       [](int a, int b) { return std::gcd(a, b); });
    if (powers.empty() || common != 1) return std::nullopt;
    return Levels(system, rifs, bounds, powers).run();
}

}  // namespace pxm::host
