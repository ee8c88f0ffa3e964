// The Pixel Machine: an array of nodes, a broadcast to all of them, and a run of one program on
// each. Nodes share nothing during a frame, so host threads take whole nodes and none waits for
// another.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "pxm/fault.hpp"
#include "pxm/frame_buffer.hpp"
#include "pxm/model.hpp"
#include "pxm/node.hpp"
#include "pxm/scheduler.hpp"

namespace pxm {

/// The nodes of a model, computing with Real: dsp32::Float, float or double.
template <class Real>
class Machine {
  public:
    /// With nodes as they are when they are switched on.
    explicit Machine(const Model& model) : model_(model) {
        for (int row = 0; row < model.rows; ++row) {
            for (int column = 0; column < model.columns; ++column) {
                nodes_.emplace_back(NodeId{column, row}, row * model.columns + column);
            }
        }
    }

    [[nodiscard]] const Model& model() const noexcept { return model_; }     // as it was given
    [[nodiscard]] std::span<Node<Real>> nodes() noexcept { return nodes_; }  // row by row

    /// Makes room in every front buffer for the node's share of a width x height raster.
    [[nodiscard]] std::optional<Fault> open_frame(int width, int height) {
        for (Node<Real>& node : nodes_) {
            const std::int64_t bytes = owned_pixels(model_, node.id(), width, height) * 4;
            if (!node.front_buffer().reserve(bytes)) {
                return Fault{node.index(), node.front_buffer().name(), bytes,
                             node.front_buffer().limit_bytes()};
            }
        }
        return std::nullopt;
    }

    /// Loads a program of so many bytes, constants included, with room for its stack, into every
    /// node's fast memory. The instructions themselves run on the host.
    [[nodiscard]] std::optional<Fault> load_program(std::int64_t program_bytes,
                                                    std::int64_t stack_bytes) {
        for (Node<Real>& node : nodes_) {
            if (auto fault = node.load_program(program_bytes, stack_bytes)) return fault;
        }
        return std::nullopt;
    }

    /// Writes the same words into every node's back frame buffer, from address 0 on.
    [[nodiscard]] std::optional<Fault> broadcast(std::span<const std::uint32_t> words) {
        return broadcast_to(&Node<Real>::back_buffer, words);
    }

    /// The same into every node's texture memory.
    [[nodiscard]] std::optional<Fault> broadcast_textures(std::span<const std::uint32_t> words) {
        return broadcast_to(&Node<Real>::texture, words);
    }

    /// Sets every node's heap up, entries in z-buffer memory and their order in fast memory. Load
    /// the program first.
    [[nodiscard]] std::optional<Fault> reserve_heap(int capacity, std::int64_t entry_bytes) {
        for (Node<Real>& node : nodes_) {
            if (auto fault = node.reserve_heap(capacity, entry_bytes)) return fault;
        }
        return std::nullopt;
    }

    /// Runs the program once on every node, on `threads` host threads; the fault of the first
    /// halted node in node order, if any halted. The program must not throw.
    [[nodiscard]] std::optional<Fault> run(const std::function<void(Node<Real>&)>& program,
                                           int threads) {
        for_each_node(static_cast<int>(nodes_.size()), threads,
                      [&](int index) { program(nodes_[static_cast<std::size_t>(index)]); });
        for (const Node<Real>& node : nodes_) {
            if (node.halted()) return node.halted();
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] std::optional<Fault> broadcast_to(Bank& (Node<Real>::*bank_of)() noexcept,
                                                    std::span<const std::uint32_t> words) {
        const auto bytes = static_cast<std::int64_t>(words.size_bytes());
        for (Node<Real>& node : nodes_) {
            Bank& bank = (node.*bank_of)();
            if (!bank.reserve(bytes)) {
                return Fault{node.index(), bank.name(), bytes, bank.limit_bytes()};
            }
            std::ranges::copy(words, bank.words().begin());
        }
        return std::nullopt;
    }

    Model model_;
    std::vector<Node<Real>> nodes_;
};

}  // namespace pxm
