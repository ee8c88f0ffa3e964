// Who computes which pixel: ways to share the pixels of a frame among nodes, and what each would
// have cost, from the cycles that every pixel took in one render. Nothing is rendered again.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace pxm::host {

/// What the pixels of a frame cost, row by row.
struct Work {
    long columns = 0;
    long rows = 0;
    std::vector<std::uint64_t> cycles;
    std::vector<std::uint32_t> shuffled;  // the pixels' places in a random order

    Work(long columns, long rows, std::vector<std::uint64_t> cycles);
    [[nodiscard]] std::uint64_t at(long x, long y) const {
        return cycles[static_cast<std::size_t>(y * columns + x)];
    }
};

/// An array of nodes. Its frame buffer is interleaved: node (i, j) holds the pixels with
/// x mod columns = i and y mod rows = j (Ch. 19), whoever computes them.
struct NodeArray {
    long columns = 1;
    long rows = 1;
    [[nodiscard]] long nodes() const { return columns * rows; }
};

/// `count` nodes, a power of 2, as square as can be: 32 are 8 x 4, as in the 932.
[[nodiscard]] NodeArray array_of(long count);

enum class Partition {
    interleaved,  // every node computes the pixels it holds: the Pixel Machine
    blocks,       // one rectangle a node
    rows,         // a band of rows a node
    columns,      // a band of columns a node
    random,       // pixels are dealt out in a random order, to all nodes alike
    dynamic       // tiles are handed out, in order, to the node that is free first
};
inline constexpr Partition all_partitions[] = {Partition::interleaved, Partition::blocks,
                                               Partition::rows,        Partition::columns,
                                               Partition::random,      Partition::dynamic};
[[nodiscard]] std::string_view name_of(Partition partition);

/// What a partition costs beside the pixels, in cycles of a node. All assumed.
struct HandOutCosts {
    std::uint64_t gather = 20;     // send a pixel to the node that holds it: 32 bits at 8 Mbit/s
    std::uint64_t hand_out = 200;  // ask for a tile and be answered: 40 microseconds
    long tile = 8;                 // pixels a side, dynamic
};

/// What would have come of it.
struct Share {
    std::vector<std::uint64_t> cycles;  // of each node, overhead included
    std::uint64_t useful = 0;           // cycles of all pixels
    std::uint64_t overhead = 0;         // cycles of gather and hand-out, all nodes
    std::uint64_t slowest = 0;          // cycles of the node that ends last: the frame's time
    /// Useful work over what the nodes could have done meanwhile; mean over maximum if there is no
    /// overhead.
    [[nodiscard]] double efficiency() const;
    /// Over one node that computes all pixels.
    [[nodiscard]] double speed_up() const;
    [[nodiscard]] double seconds() const;
};
[[nodiscard]] Share share_out(const Work& work, const NodeArray& array, Partition partition,
                              const HandOutCosts& costs = {});

}  // namespace pxm::host
