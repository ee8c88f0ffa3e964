// A diagnostic program: a token goes round the torus. It visits every node once, row after row to
// the east and the south, and then goes home to node 0 to the north and the west, so that links of
// all four directions carry it. Node code: no allocation, no exceptions, and a program that only
// looks at its own ports once a superstep.
#pragma once

#include "pxm/link.hpp"

namespace pxm::kernels {

/// The token: how many nodes it has visited, and over how many links it came.
struct Token {
    std::uint32_t visited;  // nodes
    std::uint32_t hops;     // links

    /// As it is sent: hops in the high half.
    [[nodiscard]] constexpr std::uint32_t word() const noexcept { return hops << 16 | visited; }
    /// As it was received.
    [[nodiscard]] static constexpr Token from_word(std::uint32_t word) noexcept {
        return {word & 0xFFFF, word >> 16};
    }
};

/// One node of the program. Node 0 makes the token in its first step.
class TokenNode {
  public:
    /// Of an array of that size.
    TokenNode(int column, int row, int columns, int rows) noexcept
        : column_(column), row_(row), columns_(columns), rows_(rows) {}

    /// Times the token was here on its way out.
    [[nodiscard]] int visits() const noexcept { return visits_; }
    /// At node 0, when the token has come home: its count of links.
    [[nodiscard]] std::optional<Token> home() const noexcept { return home_; }

    /// One superstep.
    Progress step(Ports& ports) noexcept {
        if (column_ == 0 && row_ == 0 && visits_ == 0) take(Token{0, 0});
        for (const Direction from : all_directions) {
            if (const auto word = ports.receive(from)) take(Token::from_word(*word));
        }
        if (held_ && ports.send(way_, Token{held_->visited, held_->hops + 1}.word())) held_.reset();
        return held_ ? Progress::working : Progress::finished;
    }

  private:
    /// Decides where a token that has arrived goes next.
    void take(Token token) noexcept {
        const auto nodes = static_cast<std::uint32_t>(columns_ * rows_);
        if (token.visited < nodes) {
            ++visits_;
            ++token.visited;
            way_ = token.visited % static_cast<std::uint32_t>(columns_) == 0 ? Direction::south
                                                                             : Direction::east;
        }
        held_ = token;
        if (token.visited < nodes) return;
        if (row_ == 0 && column_ == 0) {
            home_ = token;
            held_.reset();
        } else {
            way_ = row_ != 0 ? Direction::north : Direction::west;
        }
    }

    int column_;
    int row_;
    int columns_;
    int rows_;
    int visits_ = 0;
    Direction way_ = Direction::east;
    std::optional<Token> held_;
    std::optional<Token> home_;
};

}  // namespace pxm::kernels
