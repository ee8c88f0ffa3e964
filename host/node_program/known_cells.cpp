#include "host/node_program/known_cells.hpp"

namespace pxm::host {

bool KnownCells::contains(const CellSketch& sketch, double exit, double size) noexcept {
    const std::size_t mask = entries_.size() - 1;
    std::size_t place = sketch.low() & mask;
    for (; entries_[place].ray == ray_; place = (place + 1) & mask) {
        Entry& entry = entries_[place];
        if (entry.low != sketch.low() || entry.high != sketch.high()) continue;
        if (size >= entry.size && exit <= entry.exit) return true;
        if (size <= entry.size && exit >= entry.exit) {
            // From here on this cell knows all that the earlier one knew.
            entry.exit = exit;
            entry.size = size;
            return false;
        }
    }
    if (count_ == room) return false;
    ++count_;
    entries_[place] = {sketch.low(), sketch.high(), exit, size, ray_};
    return false;
}

}  // namespace pxm::host
