// A hash of 64 bits (FNV-1a): enough to tell apart what nobody forged.
#pragma once

#include <cstdint>
#include <span>

namespace pxm::host {

class Digest {
  public:
    /// A byte, or another small number that stands for one unit of what is hashed.
    constexpr void add(std::uint64_t unit) { value_ = (value_ ^ unit) * 0x100'0000'01b3; }
    template <class Unit>
    constexpr void add_all(std::span<const Unit> units) {
        for (const Unit unit : units) add(unit);
    }
    [[nodiscard]] constexpr std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf2'9ce4'8422'2325;
};

}  // namespace pxm::host
