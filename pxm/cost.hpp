// The cost table: instruction cycles per operation, by default half way between hand-scheduled
// ("tight") and latencies paid with no-ops ("plain"). Assumed where docs/machine.md says so.
#pragma once

#include <array>
#include <cstdint>

#include "pxm/tally.hpp"

namespace pxm {

/// Cycles of one operation, hand-scheduled and with latencies paid by no-ops.
struct OperationCost {
    double tight;
    double plain;
};

/// Cycles per operation and the mix of the two columns: 0 all tight, 1 all plain.
struct CostTable {
    std::array<OperationCost, operation_count> operations;
    double plain_share = 0.5;

    /// Cycles of one operation of this kind.
    [[nodiscard]] double cycles_of(Operation operation) const noexcept {
        const OperationCost cost = operations[static_cast<std::size_t>(operation)];
        return cost.tight + plain_share * (cost.plain - cost.tight);
    }
};

/// The table of machine-facts, Sec. 6.
[[nodiscard]] const CostTable& default_cost_table();

/// Instruction cycles (200 ns each) that a tally stands for, rounded to the nearest whole cycle.
[[nodiscard]] std::uint64_t cycles(const Tally& tally, const CostTable& table) noexcept;

}  // namespace pxm
