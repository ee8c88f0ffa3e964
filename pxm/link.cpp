#include "pxm/link.hpp"

#include <algorithm>

#include "pxm/scheduler.hpp"

namespace pxm {

bool Fifo::put(std::uint32_t word) noexcept {
    if (full()) return false;
    words_[(first_ + size_++) % capacity] = word;
    return true;
}

std::optional<std::uint32_t> Fifo::take() noexcept {
    if (empty()) return std::nullopt;
    const std::uint32_t word = words_[first_];
    first_ = (first_ + 1) % capacity;
    --size_;
    return word;
}

Torus::Torus(const Model& model)
    : columns_(model.columns), rows_(model.rows), ports_(static_cast<std::size_t>(nodes())) {}

int Torus::neighbour(int node, Direction direction) const noexcept {
    int column = node % columns_;
    int row = node / columns_;
    switch (direction) {
        case Direction::north:
            row = (row + rows_ - 1) % rows_;
            break;
        case Direction::south:
            row = (row + 1) % rows_;
            break;
        case Direction::east:
            column = (column + 1) % columns_;
            break;
        case Direction::west:
            column = (column + columns_ - 1) % columns_;
            break;
    }
    return row * columns_ + column;
}

void Torus::deliver() noexcept {
    for (int node = 0; node < nodes(); ++node) {
        for (const Direction direction : all_directions) {
            Fifo& from = ports(node).outgoing_[static_cast<std::size_t>(direction)];
            Fifo& to = ports(neighbour(node, direction))
                           .incoming_[static_cast<std::size_t>(opposite(direction))];
            while (!from.empty() && !to.full()) (void)to.put(*from.take());
        }
    }
}

bool Torus::carries_words() const noexcept {
    const auto filled = [](const Fifo& fifo) { return !fifo.empty(); };
    return std::ranges::any_of(ports_, [&](const Ports& ports) {
        return std::ranges::any_of(ports.outgoing_, filled) ||
               std::ranges::any_of(ports.incoming_, filled);
    });
}

std::optional<int> run_supersteps(Torus& torus,
                                  const std::function<Progress(int node, Ports& ports)>& program,
                                  int threads, int most) {
    std::vector<Progress> said(static_cast<std::size_t>(torus.nodes()));
    for (int step = 1; step <= most; ++step) {
        for_each_node(torus.nodes(), threads, [&](int node) {
            said[static_cast<std::size_t>(node)] = program(node, torus.ports(node));
        });
        torus.deliver();
        const bool all = std::ranges::count(said, Progress::finished) == torus.nodes();
        if (all && !torus.carries_words()) return step;
    }
    return std::nullopt;
}

}  // namespace pxm
