// The cost table: instruction cycles of 200 ns per operation, in two columns: "tight" is scheduled
// by hand with all latencies filled, "plain" pays them with no-ops. The default takes half way
// between (machine-facts, Sec. 6; docs/machine.md, "Counted time"). Every number says how surely it
// is known.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "pxm/model.hpp"
#include "pxm/tally.hpp"

namespace pxm {

/// Cycles of one operation, hand-scheduled and with latencies paid by no-ops.
struct OperationCost {
    double tight;  // cycles, scheduled by hand
    double plain;  // cycles, with no-ops
};

/// An operation of the default table: what it costs, how surely that is known, and from where.
struct CostEntry {
    Operation operation;        // which one
    OperationCost cost;         // cycles
    Certainty certainty;        // how surely they are known
    std::string_view source;    // where they are from: a key of docs/references.md, or a document
    std::string_view sentence;  // what that says, or how it was derived
};

/// The default table, in the order of Operation.
[[nodiscard]] std::span<const CostEntry, operation_count> default_cost_entries() noexcept;

/// Cycles per operation and what stands between the two columns.
struct CostTable {
    std::array<OperationCost, operation_count> operations{};  // by Operation
    double plain_share = 0.5;                                 // A: 0 all tight, 1 all plain
    /// A: multiplies every instruction, but no wait for memory. Tallies do not tell the inner loop,
    /// which Hart wrote in assembler, from the rest, which a compiler made: so one factor for all.
    double compiled_code_factor = 1;

    /// Cycles of one operation of this kind.
    [[nodiscard]] double cycles_of(Operation operation) const noexcept {
        const OperationCost cost = operations[static_cast<std::size_t>(operation)];
        const double mixed = cost.tight + plain_share * (cost.plain - cost.tight);
        return is_memory_wait(operation) ? mixed : compiled_code_factor * mixed;
    }
};

/// The table of default_cost_entries().
[[nodiscard]] const CostTable& default_cost_table() noexcept;

/// A cost table and where it is from: "default", or a file's path.
struct CostModel {
    std::string name;  // "default", or a file's path
    CostTable table;   // what operations cost
};

[[nodiscard]] CostModel default_cost_model();  // default_cost_table() under its name

/// Cycles (200 ns each) that a tally stands for, rounded to the nearest whole cycle.
[[nodiscard]] std::uint64_t cycles(const Tally& tally, const CostTable& table) noexcept;

/// Those of the cycles that are instructions; in the others the node waits for a slow memory.
[[nodiscard]] std::uint64_t instructions(const Tally& tally, const CostTable& table) noexcept;

}  // namespace pxm
