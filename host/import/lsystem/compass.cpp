#include "host/import/lsystem/compass.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace pxm::host {
namespace {

constexpr std::int64_t parts_a_degree = 1'000'000'000'000;
constexpr std::int64_t most_parts = std::numeric_limits<std::int64_t>::max() / 4;

/// steps / turns, if so many steps are a number of whole turns; 0 steps if none is found.
struct WholeTurns {
    std::int64_t steps = 0;
    std::int64_t turns = 0;
};

WholeTurns whole_turns(double steps_a_turn) {
    constexpr std::int64_t most_turns = 1000;
    constexpr double most_steps = 1e9;
    for (std::int64_t turns = 1; turns <= most_turns; ++turns) {
        const double steps = steps_a_turn * static_cast<double>(turns);
        if (steps > most_steps) return {};
        if (std::abs(steps - std::round(steps)) < 1e-12 * steps)
            return {static_cast<std::int64_t>(std::round(steps)), turns};
    }
    return {};
}

}  // namespace

Compass::Compass(double steps_a_turn) : turn_(360 * parts_a_degree) {
    const WholeTurns whole = whole_turns(steps_a_turn);
    if (whole.steps > 0) {
        const std::int64_t more = whole.steps / std::gcd(whole.steps, turn_);
        if (more <= most_parts / turn_) {
            turn_ *= more;
            step_ = within(turn_ / whole.steps * whole.turns);
            return;
        }
    }
    step_ = within(std::llround(static_cast<long double>(turn_) / steps_a_turn));
}

std::int64_t Compass::within(std::int64_t parts) const {
    const std::int64_t rest = parts % turn_;
    return rest < 0 ? rest + turn_ : rest;
}

std::int64_t Compass::of_steps(double steps) const {
    std::int64_t direction = 0;
    std::int64_t doubled = step_;
    for (auto rest = std::llround(std::abs(steps)); rest > 0; rest /= 2) {
        if (rest % 2 == 1) direction = sum(direction, doubled);
        doubled = sum(doubled, doubled);
    }
    return steps < 0 ? opposite(direction) : direction;
}

std::int64_t Compass::of_degrees(double degrees) const {
    const long double turns = std::remainder(static_cast<long double>(degrees), 360.0L) / 360;
    const std::int64_t parts_a_unit = turn_ / (360 * parts_a_degree);
    const long double units = std::round(turns * (360.0L * parts_a_degree));
    return within(static_cast<std::int64_t>(units) * parts_a_unit);
}

std::int64_t Compass::sum(std::int64_t a, std::int64_t b) const {
    return b == 0 || a < turn_ - b ? a + b : a - (turn_ - b);
}

double Compass::degrees(std::int64_t direction) const {
    const std::int64_t turned = direction > turn_ / 2 ? direction - turn_ : direction;
    return static_cast<double>(static_cast<long double>(turned) / static_cast<long double>(turn_) *
                               360);
}

const LongComplex& Compass::vector(std::int64_t direction) const {
    const auto [place, added] = vectors_.try_emplace(direction);
    if (added) {
        const LongReal radians = 8 * atan(LongReal(1)) * direction / LongReal(turn_);
        place->second = {cos(radians), sin(radians)};
    }
    return place->second;
}

}  // namespace pxm::host
