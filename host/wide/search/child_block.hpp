// Cells below an entry cell whose maps are affine: children in blocks that rays share.
#pragma once

#include <cstdint>
#include <vector>

#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

/// The children of a cell below an entry cell, in lanes; shared by the rays that open it.
/// Rows: from the entry cell's unit coordinates to the children's (12), their diameters, their
/// constants, and where the Lipschitz method needs them their composed linear parts (9).
struct Block {
    static constexpr int map = 0;
    static constexpr int diameter = 12;
    static constexpr int constant = 13;
    static constexpr int linear = 14;
    static constexpr int product_rows = 14;
    static constexpr int polar_rows = 23;

    int set = 0;
    int parent = -1;          // block; -1: the entry cell
    int lane = 0;             // in the parent block
    std::uint32_t level = 0;  // of the children
    bool last = false;        // they are terminal whatever their size
    int stride = 0;           // of the rows: block_stride() of the set
    float* rows = nullptr;
    int* opened = nullptr;  // the block of each child, or -1
};

/// How far the rows of a set's blocks are apart. Few children are kept close together, in lanes of
/// their number: a tile opens cells by the ten thousand, and they share the cache.
[[nodiscard]] inline int block_stride(const WideSet& set) {
    return set.count <= 4 ? 4 : set.count <= 8 ? 8 : set.stride;
}

/// Floats and ints that live until the packet is done: 128 MiB until it is full, and a cell more.
class Arena {
  public:
    void clear() {
        chunk_ = 0;
        used_ = 0;
    }
    /// Room for so many floats, a multiple of four.
    [[nodiscard]] float* floats(std::size_t count);
    [[nodiscard]] int* ints(std::size_t count) { return reinterpret_cast<int*>(floats(count)); }
    [[nodiscard]] bool is_full() const { return chunk_ >= most_chunks; }

  private:
    static constexpr std::size_t chunk_floats = std::size_t{1} << 18;
    static constexpr std::size_t most_chunks = 128;
    std::vector<hwy::AlignedFreeUniquePtr<float[]>> chunks_;
    std::size_t chunk_ = 0;
    std::size_t used_ = 0;
};

/// What a ray has met of up to `room` cells.
struct MetCells {
    static constexpr int room = opened_cell_room;

    alignas(64) float key[room];
    int count;               // cells that were tested
    std::uint64_t waiting;   // those that were met and not looked into, a bit each
    std::uint64_t terminal;  // these are terminal if they are met
};

/// What a ray has met of the children in a block, those from `first` on.
struct MetChildren : MetCells {
    alignas(64) float exit[room];
    int block;
    int first;
};

}  // namespace pxm::host::wide
