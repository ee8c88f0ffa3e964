// The directions of a turtle as whole parts of a turn, so that sums of turns are exact.
#pragma once

#include <cstdint>
#include <map>

#include "host/import/lsystem/long_number.hpp"

namespace pxm::host {

class Compass {
  public:
    /// A turn is `steps_a_turn` steps (at least 1, need not be whole).
    explicit Compass(double steps_a_turn);

    /// Parts of a turn, 0 <= parts < a turn.
    [[nodiscard]] std::int64_t of_steps(double steps) const;
    /// The same, rounded to 10^-12 degrees.
    [[nodiscard]] std::int64_t of_degrees(double degrees) const;
    [[nodiscard]] std::int64_t sum(std::int64_t a, std::int64_t b) const;
    [[nodiscard]] std::int64_t opposite(std::int64_t a) const { return a == 0 ? 0 : turn_ - a; }

    /// -180 < degrees <= 180.
    [[nodiscard]] double degrees(std::int64_t direction) const;
    /// The unit vector, right in all digits of a LongReal but the last few.
    [[nodiscard]] const LongComplex& vector(std::int64_t direction) const;

  private:
    [[nodiscard]] std::int64_t within(std::int64_t parts) const;

    std::int64_t turn_ = 0;  // parts
    std::int64_t step_ = 0;  // parts
    mutable std::map<std::int64_t, LongComplex> vectors_;
};

}  // namespace pxm::host
