// What a beam found in a pixel, kept until the beam is done: shadow rays need the heap. Node code:
// no allocation, no exceptions.
#pragma once

#include "dsp_kernels/cell.hpp"

namespace pxm::kernels {

/// A cell that shows in a pixel.
template <class Real>
struct Sight {
    Cell<Real> cell;   // that shows
    Real share;        // of the pixel
    Vec3<Real> place;  // mean of its places, from the first one, in pixels
};

/// What shows in a pixel. When there is more than it holds, small shares are added to the cell that
/// has the least.
template <class Real>
struct SightList {
    static constexpr std::uint32_t capacity = 12;  // cells
    Sight<Real> sights[capacity];                  // in no order
    std::uint32_t size = 0;                        // how many there are

    /// Adds a cell, or its share to that of another.
    template <NodeLike Node>
    void add(Node& node, const Cell<Real>& cell, Real share, const Vec3<Real>& place) noexcept {
        node.tally(Operation::compare_branch, 1);
        if (size == capacity) {
            Sight<Real>& least = smallest(node);
            node.tally(Operation::multiply_add, 1);
            if (!(least.share < share)) {
                least.share = least.share + share;
                return;
            }
            write(node, least, cell, least.share + share, place);
            return;
        }
        write(node, sights[size++], cell, share, place);
    }

  private:
    template <NodeLike Node>
    static void write(Node& node, Sight<Real>& sight, const Cell<Real>& cell, Real share,
                      const Vec3<Real>& place) noexcept {
        node.tally(Operation::integer, 4);
        move_cell(node, sight.cell, cell);
        sight.share = share;
        sight.place = place;
    }
    template <NodeLike Node>
    [[nodiscard]] Sight<Real>& smallest(Node& node) noexcept {
        std::uint32_t least = 0;
        for (std::uint32_t i = 1; i < size; ++i) {
            node.tally(Operation::loop_turn, 1);
            node.tally(Operation::compare_branch, 1);
            if (sights[i].share < sights[least].share) least = i;
        }
        return sights[least];
    }
};

}  // namespace pxm::kernels
