// Drawing from a finite distribution in constant time (Walker's alias method, in Vose's form).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace pxm::host {

class AliasTable {  // a finite distribution to draw from
  public:
    /// Weights must be finite, not negative and not all zero.
    explicit AliasTable(std::span<const double> weights);

    /// The outcome that 64 random bits stand for.
    [[nodiscard]] std::uint32_t draw(std::uint64_t bits) const {
        const auto column = static_cast<std::uint32_t>((bits >> 32) * columns_.size() >> 32);
        const Column& c = columns_[column];
        return static_cast<std::uint32_t>(bits) < c.threshold ? column : c.alias;
    }

  private:
    struct Column {
        std::uint32_t threshold;  // of 2^32: below it the column itself, else its alias
        std::uint32_t alias;
    };
    std::vector<Column> columns_;
};

}  // namespace pxm::host
