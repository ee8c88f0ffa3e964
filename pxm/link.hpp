// Serial links between neighbouring nodes on the torus of the array [S1]. Renders do not use them,
// Hart did not either (Ch. 19); programs may. A node's program sees its own four ports only: words
// it sent leave them, and words for it arrive in them, between the supersteps of the machine. So no
// node waits for another, a full or empty port is a value the program sees, and what happens does
// not depend on which node runs first. Buffer sizes and rates are in no source: the depth is
// assumed, the time is not modelled.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "pxm/model.hpp"

namespace pxm {

enum class Direction : std::uint8_t { north, south, east, west };  // of a link, from the node
/// In the order of Direction.
inline constexpr std::array<Direction, 4> all_directions{Direction::north, Direction::south,
                                                         Direction::east, Direction::west};

/// The direction back.
[[nodiscard]] constexpr Direction opposite(Direction direction) noexcept {
    switch (direction) {
        case Direction::north:
            return Direction::south;
        case Direction::south:
            return Direction::north;
        case Direction::east:
            return Direction::west;
        case Direction::west:
            return Direction::east;
    }
    return direction;
}

/// Words in the order they came, at most `capacity`.
class Fifo {
  public:
    static constexpr std::size_t capacity = 16;  // A, words

    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }  // there is no word in it
    /// There is no room in it.
    [[nodiscard]] bool full() const noexcept { return size_ == capacity; }
    /// False, and nothing is changed, if the buffer is full.
    [[nodiscard]] bool put(std::uint32_t word) noexcept;
    /// Nothing if the buffer is empty.
    [[nodiscard]] std::optional<std::uint32_t> take() noexcept;

  private:
    std::array<std::uint32_t, capacity> words_{};
    std::size_t first_ = 0;
    std::size_t size_ = 0;
};

/// One node's end of its four links.
class Ports {
  public:
    /// False if the link is full: nothing was sent, and the program may try in a later superstep.
    [[nodiscard]] bool send(Direction to, std::uint32_t word) noexcept {
        return outgoing_[static_cast<std::size_t>(to)].put(word);
    }
    /// Nothing if no word has arrived.
    [[nodiscard]] std::optional<std::uint32_t> receive(Direction from) noexcept {
        return incoming_[static_cast<std::size_t>(from)].take();
    }

  private:
    friend class Torus;
    std::array<Fifo, 4> outgoing_;
    std::array<Fifo, 4> incoming_;
};

/// All links of an array. Nodes are numbered row * columns + column; north is the row above.
class Torus {
  public:
    explicit Torus(const Model& model);  // of a model's array

    [[nodiscard]] int nodes() const noexcept { return columns_ * rows_; }  // of the array
    /// The node next to this one; the array's edges are joined.
    [[nodiscard]] int neighbour(int node, Direction direction) const noexcept;
    /// The links of a node; Precondition: it is one of nodes().
    [[nodiscard]] Ports& ports(int node) noexcept { return ports_[static_cast<std::size_t>(node)]; }

    /// Takes sent words to their neighbours, as many as there is room for; the others stay.
    void deliver() noexcept;
    /// Whether a word is on its way or waits to be received.
    [[nodiscard]] bool carries_words() const noexcept;

  private:
    int columns_;
    int rows_;
    std::vector<Ports> ports_;
};

/// What a node says after a superstep.
enum class Progress : std::uint8_t { working, finished };

/// Runs `program` once on every node, delivers, and so on, until in one superstep all nodes said
/// `finished` and the links are empty. The number of supersteps, or nothing after `most` of them.
/// `program` must not throw and touches nothing but its node's state and ports.
[[nodiscard]] std::optional<int> run_supersteps(
    Torus& torus, const std::function<Progress(int node, Ports& ports)>& program, int threads,
    int most);

}  // namespace pxm
