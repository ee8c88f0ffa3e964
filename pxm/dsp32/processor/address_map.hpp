// Where a node's memories appear in the 64 KiB that its DSP32 addresses. No source has this map:
// how the slow banks were paged in is not known (docs/machine.md). All of it is assumed, and all of
// the assumption is here.
//   0x0000  fast memory, 36,864 bytes
//   0xA000  window on the back buffer     0xB000  on the z-buffer
//   0xC000  on the texture memory         0xD000  on the front buffer
//   0xF000  four registers of 16 bits: which 4 KiB of its bank each window shows
#pragma once

#include <array>
#include <cstdint>

#include "pxm/node.hpp"

namespace pxm::dsp32::processor {

inline constexpr std::uint32_t page_bytes = 4096;          // A
inline constexpr std::uint32_t address_bytes = 65'536;     // R: addresses of 16 bits
inline constexpr std::uint32_t first_window_page = 0xA;    // A
inline constexpr std::uint32_t window_count = 4;           // A
inline constexpr std::uint32_t window_registers = 0xF000;  // A
inline constexpr unsigned slow_wait_cycles = 1;  // A: setting a window is the program's work
/// A program that returns to this address has ended.
inline constexpr std::uint32_t return_address = 0xFFFC;  // A

using ProcessorNode = Node<Float>;  // whose memories are addressed

/// The bank behind a window, by the window's number.
[[nodiscard]] inline Bank& bank_of_window(ProcessorNode& node, std::uint32_t window) noexcept {
    switch (window) {
        case 0:
            return node.back_buffer();
        case 1:
            return node.zbuffer();
        case 2:
            return node.texture();
        default:
            return node.front_buffer();
    }
}

/// 4 KiB of addresses: the words behind them, as far as there are any, and what each costs.
struct Page {
    std::uint32_t* words = nullptr;  // the first of them; null: none
    std::uint32_t count = 0;         // how many
    unsigned wait_cycles = 0;        // of an access
};

inline constexpr std::size_t page_count = address_bytes / page_bytes;  // of all addresses
using PageTable = std::array<Page, page_count>;                        // by their numbers

/// The part of a bank that starts at `from_bytes`, as far as it is reserved.
[[nodiscard]] inline Page page_of(Bank& bank, std::uint32_t from_bytes,
                                  unsigned wait_cycles) noexcept {
    const auto words = bank.words();
    const std::size_t first = from_bytes / 4;
    if (first >= words.size()) return {nullptr, 0, wait_cycles};
    const std::size_t count = std::min<std::size_t>(words.size() - first, page_bytes / 4);
    return {words.data() + first, static_cast<std::uint32_t>(count), wait_cycles};
}

/// The pages of a node whose windows show these parts of their banks.
[[nodiscard]] inline PageTable pages_of(ProcessorNode& node,
                                        const std::array<std::uint16_t, window_count>& shown) {
    PageTable pages{};
    for (std::uint32_t i = 0; i < (fast_memory_bytes + page_bytes - 1) / page_bytes; ++i)
        pages[i] = page_of(node.fast_memory(), i * page_bytes, 0);
    for (std::uint32_t i = 0; i < window_count; ++i)
        pages[first_window_page + i] =
            page_of(bank_of_window(node, i), shown[i] * page_bytes, slow_wait_cycles);
    return pages;
}

}  // namespace pxm::dsp32::processor
