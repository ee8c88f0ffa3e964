// A cell: the instance of a bounding volume that a word of maps leads to, as one ray meets it. This
// is an entry of the heap. The inverse M_i^-1 of Alg. 12.4 is kept as what it is needed for: the
// ray's origin o M_i^-1 and direction d M_i^-1. Node code: no allocation, no exceptions.
#pragma once

#include <cstddef>
#include <cstring>

#include "dsp_kernels/ray.hpp"
#include "dsp_kernels/word.hpp"

namespace pxm::kernels {

/// A cell along a ray: the image of a volume under a word of maps.
template <class Real>
struct Cell {
    Ray<Real> ray;          // in the cell's own coordinates, re-based to its volume's centre
    Real key{};             // start of the ray's interval: max(parent's key, entry), Erratum 3
    Real exit{};            // its end: min(parent's exit, exit)
    Real constant{};        // Lipschitz constant of the composed map (product, determinant)
    Linear<Real> linear{};  // composed linear part (polar)
    Vec3<Real> lost[2]{};   // unit axes that lifted singular maps squashed, as far as counted
    std::uint32_t lost_axes = 0;   // how many there are in `lost`
    std::uint32_t object = 0;      // address of the object record
    std::uint32_t follow_set = 0;  // address of the volume's record and the maps that may come next
    std::uint16_t level = 0;       // length of the word
    std::uint16_t bits = 1;        // of a symbol
    CellWord word;                 // only the part in use is kept
};

/// Words of a cell that are kept.
template <class Real>
[[nodiscard]] std::uint32_t cell_words(const Cell<Real>& cell) noexcept {
    return static_cast<std::uint32_t>(offsetof(Cell<Real>, word) / 4) +
           CellWord::used(cell.level, cell.bits);
}

/// Copies a cell, of its word only the part in use.
template <class Real>
void copy_cell(Cell<Real>& to, const Cell<Real>& from) noexcept {
    std::memcpy(static_cast<void*>(&to), &from, std::size_t{4} * cell_words(from));
}

/// The same, of a program that pays for it: an instruction moves a word.
template <NodeLike Node, class Real = typename Node::Real>
void move_cell(Node& node, Cell<Real>& to, const Cell<Real>& from) noexcept {
    node.tally(Operation::integer, cell_words(from));
    copy_cell(to, from);
}

/// The order in which cells are searched and shown: (key, object, word).
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] bool before(Node& node, const Cell<Real>& a, const Cell<Real>& b) noexcept {
    node.tally(Operation::compare_branch, 1);
    if (a.key < b.key) return true;
    if (b.key < a.key) return false;
    node.tally(Operation::integer, 2U + CellWord::used(a.level, a.bits));
    node.tally(Operation::heap_sequential, 1U + CellWord::used(a.level, a.bits));  // one of the two
    if (a.object != b.object) return a.object < b.object;
    return word_before(a.word, a.level, b.word, b.level, a.bits);
}

}  // namespace pxm::kernels
